using System.Collections.Concurrent;
using System.Diagnostics;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Reader;

// Asks the server's command channel for what an Axis Neuron stream does not contain: the order of the rotation values and the skeleton variant, which
// follows from the names in the BVH header. On request it also asks for the sizes of bodies. It asks on every connection of the reader, and repeats failed
// questions at growing intervals. The status message contains what it learns about the format, or why it learns nothing. No code waits for it. Any thread.
internal sealed class ServerDiscovery(NeuronCommandOptions options, FrameFormat format, Action learnt) : IDisposable
{
    // A user who switches on the command channel while frames arrive should not have to restart the reader.
    private static readonly long FirstRetry = 5 * Stopwatch.Frequency;
    private const int MaxDoublings = 3;

    // Servers count from 0, and all avatars of a server have the same kind of skeleton.
    private const int FirstAvatar = 0;

    // Indices come from the network, so invented avatars must not fill the memory.
    private const int MaxBodies = 256;

    private readonly object _lock = new();
    private readonly ConcurrentDictionary<int, BodyAnswer?> _bodies = new();
    private volatile bool _areSizesWanted;
    private bool _isAsking;
    private bool _isRequested;
    private bool _isStopped;
    private bool _hasBegun;
    private int _failures;
    private long _failed;
    private volatile bool _hasNewBodies;

    // Questions of others, for example of an export, also go through this object and are asked only once.
    public ServerInquiry Inquiry { get; } = new(options);

    // Called with the sizes of the first avatar, after WantSizes was called.
    public Action<BoneDimensions> SizesLearnt { get; set; } = static _ => { };

    // A connection is established.
    public void Begin()
    {
        Inquiry.Renew();
        lock (_lock)
        {
            _failures = 0;
            _hasBegun = true;
        }

        Ask(isRetry: false);
    }

    // Timer, while connected.
    public void Check(long now)
    {
        bool isDue;
        lock (_lock)
        {
            if (_isAsking)
                return;

            isDue = _failures > 0 && now - _failed > FirstRetry << Math.Min(_failures - 1, MaxDoublings);
        }

        if (isDue || _hasNewBodies)
            Ask(isDue);
    }

    // Asks for sizes now and on every connection.
    public void WantSizes()
    {
        _areSizesWanted = true;
        Ask(isRetry: false);
    }

    // Null until the server has answered. The first call makes the timer ask; no call waits.
    public SkeletonBody? FindBody(int avatarIndex)
    {
        if (_bodies.TryGetValue(avatarIndex, out BodyAnswer? answer))
            return answer?.GetBody(format.Variant);

        if (avatarIndex >= 0 && _bodies.Count < MaxBodies && _bodies.TryAdd(avatarIndex, null))
            _hasNewBodies = true;

        return null;
    }

    // Asks no more questions on its own. An export may still wait for an answer.
    public void Stop()
    {
        lock (_lock)
            _isStopped = true;
    }

    // Cancels the questions, without waiting for their end.
    public void Dispose()
    {
        Stop();
        Inquiry.Dispose();
    }

    private void Ask(bool isRetry)
    {
        lock (_lock)
        {
            _isRequested = true;
            if (_isAsking || _isStopped || !_hasBegun)
                return;

            _isAsking = true;
        }

        _ = AskAsync(isRetry);
    }

    private async Task AskAsync(bool isRetry)
    {
        while (TryBeginRound())
        {
            bool isComplete = false;
            try
            {
                isComplete = await AskEverythingAsync(isRetry).ConfigureAwait(false);
            }
            catch (ObjectDisposedException)
            {
                // The reader was stopped.
            }
            catch (Exception)
            {
                // The library has a bug, or the system is out of memory. Retries as after any other failure.
            }

            EndRound(isComplete, isRetry);
            isRetry = false;
        }
    }

    private bool TryBeginRound()
    {
        lock (_lock)
        {
            _isAsking = _isRequested && !_isStopped;
            _isRequested = false;
            return _isAsking;
        }
    }

    private void EndRound(bool isComplete, bool isRetry)
    {
        lock (_lock)
        {
            if (isComplete)
                _failures = 0;
            else if (isRetry || _failures == 0)
                (_failures, _failed) = (_failures + 1, Stopwatch.GetTimestamp());
        }
    }

    // Returns false if a question has no answer. After two questions without an answer, the rest are not asked, because that would take very long.
    private async Task<bool> AskEverythingAsync(bool isRetry)
    {
        bool isComplete = true;
        int unanswered = 0;
        _hasNewBodies = false;
        foreach (Func<bool, Task> question in Questions())
        {
            try
            {
                await question(isRetry).ConfigureAwait(false);
            }
            catch (NeuronCommandException exception)
            {
                isComplete = false;
                if (!exception.IsAnswer && ++unanswered > 1)
                    break;
            }
        }

        return isComplete;
    }

    private IEnumerable<Func<bool, Task>> Questions()
    {
        yield return AskForFormatAsync;
        if (_areSizesWanted)
            yield return async isRetry => SizesLearnt(await Inquiry.GetDimensionsAsync(FirstAvatar, isRetry).ConfigureAwait(false));

        foreach (int avatar in _bodies.Keys)
            yield return async isRetry => _bodies[avatar] = await Inquiry.GetBodyAsync(avatar, isRetry).ConfigureAwait(false);
    }

    private async Task AskForFormatAsync(bool isRetry)
    {
        try
        {
            format.Learn(await Inquiry.GetRotationOrderAsync(isRetry).ConfigureAwait(false), variant: null);
            learnt();
            BvhSkeletonMap skeleton = await Inquiry.GetSkeletonAsync(FirstAvatar, isRetry).ConfigureAwait(false);
            format.Learn(order: null, skeleton.Format.Variant);
            format.LearnFailure(null);
        }
        catch (Exception exception) when (exception is not ObjectDisposedException)
        {
            format.LearnFailure(exception is NeuronCommandException ? exception.Message : $"The command channel's answer could not be used: {exception.Message}");
            throw;
        }
        finally
        {
            learnt();
        }
    }
}
