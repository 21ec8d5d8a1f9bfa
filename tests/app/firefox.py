"""A headless Firefox, spoken to by its own protocol Marionette: nothing but Python's own library."""
import base64
import json
import os
import pathlib
import shutil
import socket
import time

import browser


def find_firefox():
    """The program, or None."""
    for name in ("firefox-esr", "firefox"):
        if found := shutil.which(name):
            return found
    return None


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Firefox(browser.Headless):
    """Firefox, by Marionette."""

    def __init__(self, program, width=1200, height=900):
        super().__init__()
        port = free_port()
        settings = {"marionette.port": port, "network.proxy.type": 1, "network.proxy.http": "127.0.0.1",
                    "network.proxy.http_port": 9, "network.proxy.ssl": "127.0.0.1", "network.proxy.ssl_port": 9,
                    "app.update.enabled": False, "datareporting.policy.dataSubmissionEnabled": False,
                    "browser.shell.checkDefaultBrowser": False, "webgl.force-enabled": True,
                    "ui.prefersReducedMotion": 1}
        (pathlib.Path(self.profile.name) / "user.js").write_text(
            "".join(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in settings.items()))
        self.start(
            [program, "--headless", "--marionette", "--remote-allow-system-access", "--no-remote", "--profile",
             self.profile.name, "--width", str(width), "--height", str(height)],
            env={**os.environ, "MOZ_HEADLESS_WIDTH": str(width), "MOZ_HEADLESS_HEIGHT": str(height),
                 "HOME": self.profile.name})
        end = time.monotonic() + 90
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port), timeout=90)
                break
            except OSError:
                if time.monotonic() > end or self.process.poll() is not None:
                    self.__exit__()
                    raise
                time.sleep(0.1)
        self._message()  # its greeting
        self.call("WebDriver:NewSession")

    def close(self):
        if hasattr(self, "socket"):
            self.socket.close()

    def _message(self):
        """A length in digits, a colon, and so many bytes of JSON."""
        while True:
            head, colon, rest = self.buffer.partition(b":")
            if colon and len(rest) >= int(head):
                text, self.buffer = rest[:int(head)], rest[int(head):]
                return json.loads(text)
            part = self.socket.recv(1 << 20)
            if not part:
                raise ConnectionError("the browser has ended")
            self.buffer += part

    def call(self, method, **parameters):
        self.number += 1
        data = json.dumps([0, self.number, method, parameters]).encode()
        self.socket.sendall(str(len(data)).encode() + b":" + data)
        _, number, error, result = self._message()
        if number != self.number:
            raise RuntimeError(f"{method}: an answer to call {number}, not {self.number}")
        if error:
            raise RuntimeError(f"{method}: {error['message']}")
        return result

    def evaluate(self, expression):
        """The value of a JavaScript expression, awaited."""
        return self.call("WebDriver:ExecuteScript", script=f"return (async () => ({expression}))()", args=[],
                         scriptTimeout=60000)["value"]

    def open(self, file):
        self.call("WebDriver:Navigate", url=pathlib.Path(file).resolve().as_uri())

    def said(self):
        """Errors and warnings of the page that came onto the browser's console."""
        self.call("Marionette:SetContext", value="chrome")
        try:
            found = self.call("WebDriver:ExecuteScript", script="""
              return Services.console.getMessageArray().filter(m => m instanceof Ci.nsIScriptError)
                .filter(m => m.sourceName.startsWith('file:')).map(m => m.errorMessage)""", args=[])["value"]
        finally:
            self.call("Marionette:SetContext", value="content")
        return found

    def screenshot(self, file):
        pathlib.Path(file).write_bytes(base64.b64decode(self.call("WebDriver:TakeScreenshot", full=True)["value"]))
