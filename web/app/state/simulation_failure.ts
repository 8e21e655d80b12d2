/** Why a worker that simulates has ended. */

import { say } from '../language/say';

/** Rejects where the program of the worker cannot be loaded, or fails. */
export const failureOf = (worker: Worker): Promise<never> =>
  new Promise((_, reject) => {
    worker.addEventListener('error', ({ message }) =>
      reject(
        new Error(
          say('The simulation has stopped: {why}.', {
            why: message ?? say('its program could not be loaded'),
          }),
        ),
      ),
    );
  });
