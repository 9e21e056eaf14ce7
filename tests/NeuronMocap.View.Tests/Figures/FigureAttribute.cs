using System.Runtime.CompilerServices;
using Xunit.v3;

namespace NeuronMocap.View.Tests.Figures;

/// <summary>A measurement of minutes, as a test. Only runs with <c>NEURONMOCAP_FIGURES=1</c> have it, so that other runs do not list it as skipped.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer(typeof(FigureDiscoverer))]
public sealed class FigureAttribute([CallerFilePath] string? sourceFilePath = null, [CallerLineNumber] int sourceLineNumber = -1)
    : FactAttribute(sourceFilePath, sourceLineNumber);
