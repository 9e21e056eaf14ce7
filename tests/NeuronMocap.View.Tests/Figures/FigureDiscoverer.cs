using Xunit.Sdk;
using Xunit.v3;

namespace NeuronMocap.View.Tests.Figures;

/// <summary>Finds a <see cref="FigureAttribute"/> in runs that ask for figures.</summary>
public sealed class FigureDiscoverer : FactDiscoverer
{
    private static readonly bool IsAsked = Environment.GetEnvironmentVariable("NEURONMOCAP_FIGURES") == "1";

    /// <inheritdoc/>
    public override ValueTask<IReadOnlyCollection<IXunitTestCase>> Discover(
        ITestFrameworkDiscoveryOptions discoveryOptions, IXunitTestMethod testMethod, IFactAttribute factAttribute) =>
        IsAsked ? base.Discover(discoveryOptions, testMethod, factAttribute) : new([]);
}
