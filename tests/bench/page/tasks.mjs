// The tasks of a page's main thread, from a trace of Chromium.

const CATEGORIES = ['toplevel', '__metadata'];

/**
 * Runs `act` and returns the longest task of the page's main thread meanwhile, in ms: by the time in which the thread computed
 * (`own`), and with its waits for the rasteriser, for other processes and for a busy processor (`lasted`); and how many tasks
 * computed for over 50 ms.
 */
export async function longestTask(browser, page, act) {
  await browser.startTracing(page, { categories: CATEGORIES });
  let events;
  try {
    await act();
  } finally {
    events = JSON.parse((await browser.stopTracing()).toString()).traceEvents;
  }
  const isMain = mainThreadOf(events);
  const tasks = events
    .filter((event) => event.ph === 'X' && event.name.endsWith('RunTask') && isMain(event))
    .map(({ dur, tdur }) => ({ own: (tdur ?? dur) / 1000, lasted: dur / 1000 }));
  if (tasks.length === 0) throw new Error('The trace has no tasks of the page.');
  const most = tasks.reduce((a, b) => (b.own > a.own ? b : a));
  const lasted = Math.max(...tasks.map((task) => task.lasted));
  return { own: most.own, lasted, over: tasks.filter(({ own }) => own > 50).length };
}

/** Of the renderer that did the most: a browser keeps one in reserve. */
function mainThreadOf(events) {
  const threads = events
    .filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain')
    .map(({ pid, tid }) => ({ pid, tid, count: 0 }));
  for (const { pid, tid } of events)
    for (const thread of threads) if (thread.pid === pid && thread.tid === tid) thread.count++;
  const main = threads.reduce((a, b) => (b.count > a.count ? b : a));
  return ({ pid, tid }) => pid === main.pid && tid === main.tid;
}
