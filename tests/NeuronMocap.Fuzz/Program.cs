return NeuronMocap.Fuzz.FuzzCommand.Invoke(args);
