#nullable enable

using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // Asks the command channel for the sizes of each avatar, in the background, until it is answered. Pool threads.
    internal sealed class BodyQuestions
    {
        private static readonly TimeSpan Period = TimeSpan.FromSeconds(0.5);
        private static readonly TimeSpan Patience = TimeSpan.FromSeconds(5);

        private readonly NeuronCommandClient _client;
        private readonly AvatarStreams _streams;
        private readonly CancellationTokenSource _stop = new CancellationTokenSource();
        private readonly Task _asking;

        public BodyQuestions(string host, int port, AvatarStreams streams)
        {
            _client = new NeuronCommandClient(host, port);
            _streams = streams;
            _asking = Task.Run(AskAsync);
        }

        public Task CloseAsync()
        {
            _stop.Cancel();
            return Task.WhenAll(_client.DisposeAsync().AsTask(), _asking);
        }

        private async Task AskAsync()
        {
            var answered = new HashSet<AvatarStream>();
            try
            {
                while (true)
                {
                    TimeSpan pause = Period;
                    foreach (AvatarStream stream in _streams.All)
                    {
                        if (answered.Contains(stream) || stream.AvatarIndex < 0)
                            continue;
                        if (await AskAsync(stream).ConfigureAwait(false))
                            answered.Add(stream);
                        else
                            pause = Patience;
                    }

                    await Task.Delay(pause, _stop.Token).ConfigureAwait(false);
                }
            }
            catch (OperationCanceledException)
            {
                // Closed.
            }
            catch (ObjectDisposedException)
            {
                // Closed, between two questions.
            }
        }

        // The BVH header says more than the twelve sizes.
        private async Task<bool> AskAsync(AvatarStream stream)
        {
            try
            {
                BvhDocument header = await _client.GetBvhHeaderAsync(stream.AvatarIndex, _stop.Token).ConfigureAwait(false);
                if (BvhSkeletonMap.TryCreate(header, out BvhSkeletonMap? map, out _))
                {
                    stream.Tell(map!.GetBody());
                    return true;
                }
            }
            catch (NeuronCommandException exception) when (exception.Reason is CommandFailure.Rejected or CommandFailure.InvalidReply)
            {
                // It answers, but not this.
            }
            catch (NeuronCommandException)
            {
                return false;
            }

            try
            {
                BoneDimensions dimensions = await _client.GetBoneDimensionsAsync(stream.AvatarIndex, _stop.Token).ConfigureAwait(false);
                stream.Tell(SkeletonBody.FromDimensions(dimensions, stream.Body.Variant));
                return true;
            }
            catch (NeuronCommandException)
            {
                return false;
            }
        }
    }
}
