using System.Reflection;
using Xunit.Sdk;
using Xunit.v3;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Runs a theory once for each name of the <see cref="GoldenPackets"/>.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class EveryGoldenPacketAttribute : DataAttribute
{
    public override ValueTask<IReadOnlyCollection<ITheoryDataRow>> GetData(MethodInfo testMethod, DisposalTracker disposalTracker) =>
        new(GoldenPackets.Names.Select(name => new TheoryDataRow(name)).ToArray());

    public override bool SupportsDiscoveryEnumeration() => true;
}
