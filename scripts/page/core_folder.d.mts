export function coreFolder(core?: string): {
  name: string;
  apply: 'build';
  config(): { define: Record<string, string> };
  configResolved(config: { root: string; build: { outDir: string } }): void;
  writeBundle(): void;
};
