// The test program reads the variables of its process: GoogleTest takes its shard from them.
Module['preRun'] = () => Object.assign(ENV, process.env);
