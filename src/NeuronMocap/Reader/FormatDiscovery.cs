using System.Diagnostics;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Frames;

namespace NeuronMocap.Reader;

// Asks the server's command channel, on every connection of the reader until it is answered, what an Axis Neuron stream does not say: the order
// of the rotation values, and through the names in the BVH header the variant of the skeleton. What it learns or why it learnt nothing becomes
// part of the status message. The reader never waits for it.
internal sealed class FormatDiscovery(NeuronCommandOptions options, FrameFormat format, Action learnt) : IDisposable
{
    // Whoever switches the command channel on while frames arrive does not want to start the reader anew.
    private static readonly long RetryPeriod = 5 * Stopwatch.Frequency;

    // Servers count from 0, and all avatars of one have the same kind of skeleton.
    private const int Avatar = 0;

    private readonly NeuronCommandClient _client = new(options);
    private int _isAsking;
    private long _asked;

    // A connection stands. Any thread.
    public void Begin()
    {
        if (Interlocked.Exchange(ref _isAsking, 1) == 0)
            _ = AskAsync();
    }

    // Timer, while a connection stands.
    public void Check(long now)
    {
        if (format.Findings.Failure is not null && now - Volatile.Read(ref _asked) > RetryPeriod)
            Begin();
    }

    // Ends the questions, without waiting for it.
    public void Dispose() => _ = _client.DisposeAsync().AsTask();

    private async Task AskAsync()
    {
        try
        {
            format.Learn(await _client.GetRotationOrderAsync().ConfigureAwait(false), variant: null);
            learnt();
            BvhDocument header = await _client.GetBvhHeaderAsync(Avatar).ConfigureAwait(false);
            if (!BvhSkeletonMap.TryCreate(header, out BvhSkeletonMap? map, out string? reason))
                throw new NeuronCommandException(CommandFailure.InvalidReply, $"The BVH header of avatar {Avatar} has another skeleton: {reason}");

            format.Learn(order: null, map.Format.Variant);
            format.LearnFailure(null);
        }
        catch (NeuronCommandException exception)
        {
            format.LearnFailure(exception.Message);
        }
        catch (ObjectDisposedException)
        {
            // The reader was stopped.
        }
        catch (Exception exception)
        {
            // A fault of ours, or out of memory: told as any other failure, and tried again as after any other.
            format.LearnFailure($"The command channel's answer could not be used: {exception.Message}");
        }
        finally
        {
            Volatile.Write(ref _asked, Stopwatch.GetTimestamp());
            Volatile.Write(ref _isAsking, 0);
            learnt();
        }
    }
}
