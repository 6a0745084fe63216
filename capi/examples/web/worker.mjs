// The program beside the page, so that the page stays alive while it works: first the module and the files come, then
// command lines, each answered in turn.
import {run} from './program.mjs';

let module, files;
addEventListener('message', ({data}) => {
  if (data.module) {
    ({module, files} = data);
    return;
  }
  try {
    postMessage(run(module, data.words, files));
  } catch (error) {
    postMessage({status: 1, errors: `this is more than the page can do (${error.message}); the program itself may`});
  }
});
