namespace NeuronMocap.Tests.Architecture.Samples;

internal sealed class RootError : Exception;

internal static class RootHelper
{
    public static void Help()
    {
    }
}
