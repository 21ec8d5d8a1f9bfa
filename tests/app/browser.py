"""Headless browsers, spoken to by their own protocols: nothing but Python's own library."""
import base64
import json
import os
import pathlib
import select
import shutil
import signal
import subprocess
import tempfile
import time


def find_chromium():
    """The program, or None."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    return None


class Headless:
    """One page of a browser that has no network; a context manager."""

    def __init__(self):
        self.profile = tempfile.TemporaryDirectory()
        self.buffer, self.number = b"", 0

    def start(self, command, **options):
        self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, start_new_session=True, **options)

    def close(self):
        """Closes the connection."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        self.close()
        for _ in range(50):  # helpers of the browser may still write into the profile
            try:
                self.profile.cleanup()
                break
            except OSError:
                time.sleep(0.1)

    def wait_for(self, expression, timeout=60):
        end = time.monotonic() + timeout
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise TimeoutError(f"never true: {expression}; the page said {self.said()}")
            time.sleep(0.05)


class Browser(Headless):
    """Chromium, by the DevTools protocol over a pipe."""

    def __init__(self, program, width=1200, height=900, dark=False, scripts=True):
        super().__init__()
        to_browser, from_browser = os.pipe(), os.pipe()
        self.writer, self.reader = to_browser[1], from_browser[0]

        def pipes():  # the browser reads from 3 and writes to 4
            read, write = os.dup(to_browser[0]), os.dup(from_browser[1])
            os.dup2(read, 3)
            os.dup2(write, 4)

        self.start(
            [program, "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--no-first-run",
             f"--user-data-dir={self.profile.name}", "--disable-dev-shm-usage", "--disable-component-update",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
             # Whatever would ask for something elsewhere fails at once.
             "--proxy-server=127.0.0.1:9", "--disable-background-networking",
             f"--window-size={width},{height}", "about:blank"],
            preexec_fn=pipes, pass_fds=(3, 4))
        os.close(to_browser[0])
        os.close(from_browser[1])
        self.events, self.session = [], None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 600)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                            {"name": "prefers-reduced-motion", "value": "reduce"}])
        if not scripts:
            self.call("Emulation.setScriptExecutionDisabled", value=True)

    def close(self):
        os.close(self.writer)
        os.close(self.reader)

    def _message(self, timeout):
        end = time.monotonic() + timeout
        while b"\0" not in self.buffer:
            if not select.select([self.reader], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            part = os.read(self.reader, 1 << 20)
            if not part:
                raise ConnectionError("the browser has ended")
            self.buffer += part
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, timeout=60, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.writer, data):]
        while True:
            answer = self._message(timeout)
            if answer.get("id") != self.number:
                self.events.append(answer)
                continue
            if "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']}")
            return answer["result"]

    def evaluate(self, expression, timeout=60):
        """The value of a JavaScript expression, awaited."""
        result = self.call("Runtime.evaluate", timeout, expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, file):
        """Opens a file from disk, to its end."""
        self.events.clear()
        self.call("Page.navigate", url=pathlib.Path(file).resolve().as_uri())
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            self.events.append(self._message(60))

    def said(self):
        """What came onto the console: messages, warnings, errors, exceptions."""
        self.evaluate("0")
        texts = []
        for event in self.events:
            method, parameters = event.get("method"), event.get("params", {})
            if method == "Runtime.consoleAPICalled":
                texts.append(" ".join(str(a.get("value", a.get("description"))) for a in parameters["args"]))
            elif method == "Runtime.exceptionThrown":
                texts.append(json.dumps(parameters["exceptionDetails"]))
            elif method == "Log.entryAdded":
                texts.append(parameters["entry"]["text"])
        return texts

    def requests(self):
        """What the page asked for, but for itself."""
        self.evaluate("0")
        return [e["params"]["request"]["url"] for e in self.events
                if e.get("method") == "Network.requestWillBeSent"
                and not e["params"]["request"]["url"].startswith(("data:", "blob:"))][1:]

    def screenshot(self, file, selector=None):
        """A picture of what the window shows, or of all of what the selector finds."""
        clip = {}
        if selector:
            box = self.evaluate(f"(() => {{ const b = document.querySelector({json.dumps(selector)})"
                                ".getBoundingClientRect(); return {x: b.x + scrollX, y: b.y + scrollY, width: b.width, "
                                "height: b.height, scale: 1}; })()")
            clip = {"clip": box, "captureBeyondViewport": True}
        image = self.call("Page.captureScreenshot", format="png", **clip)
        pathlib.Path(file).write_bytes(base64.b64decode(image["data"]))

    def media(self, name, dark=False):
        """Shows the page as on "screen" or in "print"."""
        self.call("Emulation.setEmulatedMedia", media=name,
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def printed(self):
        """The page as PDF."""
        return base64.b64decode(self.call("Page.printToPDF", printBackground=False, preferCSSPageSize=False)["data"])

    def key(self, name, text=""):
        codes = {"Tab": 9, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "End": 35, "Enter": 13,
                 "Home": 36}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, text=text if kind == "keyDown" else "",
                      windowsVirtualKeyCode=codes.get(name, 0))
