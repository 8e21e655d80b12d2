/** The open tabs. Each holds a browser lock for its lifetime, so that two tabs never save under the same name. */

const TAB_KEY = 'limber-tab';
const PREFIX = 'limber-tab-';
/** A page that is being reloaded may still hold its lock for a moment. */
const TRIES = 5;
const TRY_MILLISECONDS = 60;

export interface Tab {
  id: string;
  /** the tab whose session this one starts with: itself before a reload, or the tab that it is a copy of */
  source: string | null;
}

/** This tab. */
export const ownTab: Promise<Tab> = findTab();

async function findTab(): Promise<Tab> {
  const source = rememberedId();
  if (source !== null && (await isFree(source))) return { id: source, source };
  const id = crypto.randomUUID();
  await lock(id);
  rememberId(id);
  return { id, source };
}

/** A browser may refuse access to its storage; then no session is restored after a reload. */
function rememberedId(): string | null {
  try {
    return sessionStorage.getItem(TAB_KEY);
  } catch {
    return null;
  }
}

function rememberId(id: string): void {
  try {
    sessionStorage.setItem(TAB_KEY, id);
  } catch {
    // see `rememberedId`
  }
}

async function isFree(id: string): Promise<boolean> {
  for (let i = 0; i < TRIES; i++) {
    if (await lock(id)) return true;
    await new Promise((resolve) => setTimeout(resolve, TRY_MILLISECONDS));
  }
  return false;
}

/** Takes the lock of a tab for the lifetime of this page; returns whether it was free. Without browser locks it always is. */
function lock(id: string): Promise<boolean> {
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    void navigator.locks.request(PREFIX + id, { ifAvailable: true }, (taken) => {
      resolve(taken !== null);
      return taken ? new Promise(() => {}) : undefined;
    });
  });
}

/** The tabs that are currently open, including this one. */
export async function liveTabs(): Promise<Set<string>> {
  const locks = (await navigator.locks?.query())?.['held'] ?? [];
  const names = locks.map(({ name }) => name ?? '').filter((name) => name.startsWith(PREFIX));
  return new Set([...names.map((name) => name.slice(PREFIX.length)), (await ownTab).id]);
}
