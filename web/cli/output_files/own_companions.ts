/** Which files beside a model limber has written itself. */

import { existsSync, statSync } from 'node:fs';
import { pathsNamedBy } from '../files';
import { followLinks, identityOf } from './identity';
import { isOwnFile } from './own_files';

/** Whether the model that is there is limber's own and names the file, which exists. */
export function isOwnCompanion(path: string, model: string): boolean {
  const main = followLinks(model);
  // An empty file is nobody's, and names nothing.
  if (!existsSync(main) || statSync(main).size === 0 || !isOwnFile(main)) return false;
  return pathsNamedBy(main).some((named) => existsSync(named) && identityOf(named) === identityOf(path));
}
