#nullable enable

using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Unity
{
    // Who is in the stream. Handlers may close the source, or open it anew: each loop ends with the connection that it began with.
    public sealed partial class MocapSource
    {
        private readonly List<Performer> _performers = new List<Performer>();

        /// <summary>Raised in Update when a performer's first frame has come.</summary>
        public event Action<Performer>? PerformerJoined;

        /// <summary>Raised when a performer has had no frame for <see cref="LeaveTimeout"/>, and when the source closes.</summary>
        public event Action<Performer>? PerformerLeft;

        /// <summary>The performers, in the order in which they joined.</summary>
        public IReadOnlyList<Performer> Performers => _performers;

        /// <summary>Frames per second of a performer, the highest of all; 0 while none arrive.</summary>
        public double FrameRate
        {
            get
            {
                double rate = 0;
                for (int i = 0; i < _performers.Count; i++)
                    rate = Math.Max(rate, _performers[i].FrameRate);

                return rate;
            }
        }

        /// <summary>Finds a performer by its number on the server.</summary>
        /// <param name="avatarIndex">From 0.</param>
        /// <param name="performer">
        /// Where two servers send the same number: the one whose frames arrive; of two that are live, the one that joined first; of two that are not, the
        /// one that was heard last.
        /// </param>
        /// <returns>Whether there is one.</returns>
        public bool TryGetPerformer(int avatarIndex, [NotNullWhen(true)] out Performer? performer)
        {
            performer = null;
            for (int i = 0; i < _performers.Count; i++)
            {
                if (_performers[i].AvatarIndex == avatarIndex)
                    performer = Better(performer, _performers[i]);
            }

            return performer != null;
        }

        /// <summary>Finds a performer by its name on the server.</summary>
        /// <param name="name">In any case.</param>
        /// <param name="performer">Where two have the name, as for <see cref="TryGetPerformer(int, out Performer?)"/>.</param>
        /// <returns>Whether there is one.</returns>
        public bool TryGetPerformer(string name, [NotNullWhen(true)] out Performer? performer)
        {
            performer = null;
            for (int i = 0; i < _performers.Count; i++)
            {
                if (string.Equals(_performers[i].Name, name, StringComparison.OrdinalIgnoreCase))
                    performer = Better(performer, _performers[i]);
            }

            return performer != null;
        }

        // Live ones before others: a server that restarted elsewhere takes the place of the one that is silent, however long that stays.
        private static Performer Better(Performer? first, Performer second)
        {
            if (first == null || (!first.IsLive && (second.IsLive || second.SecondsSinceFrame < first.SecondsSinceFrame)))
                return second;

            return first;
        }

        private void TakePerformers(SourceConnection connection)
        {
            long now = SourceClock.Now;
            AvatarStream[] streams = connection.Streams.All;
            for (int i = 0; i < streams.Length && _connection == connection; i++)
            {
                if (streams[i].Frames > 0 && !IsGone(streams[i], now) && !Has(streams[i]))
                    Add(streams[i]);
            }

            var sampling = new SamplingSettings(_resample, _delay, _interpolation);
            for (int i = _performers.Count - 1; i >= 0 && _connection == connection; i--)
            {
                _performers[i].Update(now, _idleTimeout, sampling);
                if (IsGone(_performers[i].Stream, now))
                    Remove(i);
            }
        }

        private bool IsGone(AvatarStream stream, long now) =>
            _leaveTimeout > 0 && now - stream.LastArrival > SourceClock.ToTicks(Math.Max(_leaveTimeout, _idleTimeout));

        private bool Has(AvatarStream stream)
        {
            for (int i = 0; i < _performers.Count; i++)
            {
                if (_performers[i].Stream == stream)
                    return true;
            }

            return false;
        }

        private void Add(AvatarStream stream)
        {
            var performer = new Performer(stream, new SamplingSettings(_resample, _delay, _interpolation));
            _performers.Add(performer);
            Handlers.Raise(PerformerJoined, performer, this);
        }

        private void Remove(int index)
        {
            Performer performer = _performers[index];
            _performers.RemoveAt(index);
            performer.Release();
            Handlers.Raise(PerformerLeft, performer, this);
        }
    }
}
