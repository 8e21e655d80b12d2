import type initJolt from 'jolt-physics';

type Jolt = Awaited<ReturnType<typeof initJolt>>;

export function joltSoftBody(
  Jolt: Jolt,
  settings: { solver: string },
  options?: { objectLayer?: number; index?: number; step?: number },
): InstanceType<Jolt['SoftBodyCreationSettings']>;
