// A page that is written anew while its run goes on loads itself again, and shows then what it showed before.

const key = `ringwatch ${location.pathname}`;

/// What the page showed before it loaded itself again; null for nothing.
export function remembered() {
  try {
    return JSON.parse(sessionStorage.getItem(key));
  } catch {
    return null;  // a browser that keeps nothing for files
  }
}

/// Loads the page again after so many seconds, unless its reader wants it to stay.
export function startReloading(seconds, parts, before) {
  let timer = null, stays = false;
  const button = document.getElementById('stay');
  const remember = () => {
    try {
      sessionStorage.setItem(key, JSON.stringify({scroll: scrollY, stays, history: parts.history?.view(), mesh: parts.mesh?.view()}));
    } catch {
      // Then the page begins again at its top.
    }
  };
  const plan = () => {
    clearTimeout(timer);
    timer = stays ? null : setTimeout(() => { remember(); location.reload(); }, 1000 * seconds);
    button?.setAttribute('aria-pressed', String(stays));
  };
  button?.addEventListener('click', () => {
    stays = !stays;
    plan();
  });
  if (before && before.scroll > 0) scrollTo({top: before.scroll, behavior: 'instant'});
  plan();
  parts.live = {stays: () => stays, seconds};
}
