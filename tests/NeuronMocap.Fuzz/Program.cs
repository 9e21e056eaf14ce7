using NeuronMocap.Fuzz;
using NeuronMocap.Fuzz.Targets;

return new FuzzCommand(TargetList.All).Invoke(args);
