using NeuronMocap.Commands;

namespace NeuronMocap.Tests.Commands;

internal static class CommandCall
{
    public static async Task<NeuronCommandException> FailsAsync(Task call, CommandFailure reason, string told)
    {
        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => call.Soon());
        Assert.Equal(reason, exception.Reason);
        Assert.Contains(told, exception.Message, StringComparison.Ordinal);
        return exception;
    }
}
