namespace NeuronMocap.Tests.Network;

internal static class Limits
{
    // For things that happen at once unless something is broken; never reached by a test that passes.
    public static readonly TimeSpan Unexpected = TimeSpan.FromSeconds(60);

    public static Task<T> Soon<T>(this Task<T> task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);

    public static Task Soon(this Task task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);
}
