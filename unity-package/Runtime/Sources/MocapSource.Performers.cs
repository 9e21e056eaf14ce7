#nullable enable

using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Unity
{
    // The performers in the stream. Handlers may close or reopen the source, so each loop stops when its connection is no longer current.
    // A source that shares its connection gets the same one again.
    public sealed partial class MocapSource
    {
        private readonly List<Performer> _performers = new List<Performer>();

        /// <summary>Occurs in Update when a performer's first frame has arrived.</summary>
        public event Action<Performer>? PerformerJoined;

        /// <summary>Occurs when a performer has had no frame for <see cref="LeaveTimeout"/>, and when the source closes.</summary>
        public event Action<Performer>? PerformerLeft;

        /// <summary>Gets the performers, in the order in which they joined.</summary>
        public IReadOnlyList<Performer> Performers => _performers;

        /// <summary>Gets the highest frame rate of all performers, or 0 while no frames arrive.</summary>
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
        /// <param name="avatarIndex">The number, from 0.</param>
        /// <param name="performer">
        /// Receives the performer. If two servers send the same number, a live performer comes first. Of two live performers, it is the one that
        /// joined first. Of two silent performers, it is the one with the latest frame.
        /// </param>
        /// <returns>True if the performer was found.</returns>
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
        /// <param name="name">The name. Case is ignored.</param>
        /// <param name="performer">Receives the performer. For equal names, see <see cref="TryGetPerformer(int, out Performer?)"/>.</param>
        /// <returns>True if the performer was found.</returns>
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

        // The performer of one of the computers that send to the port.
        internal Performer? FindPerformer(int avatarIndex, int sender)
        {
            for (int i = 0; i < _performers.Count; i++)
            {
                if (_performers[i].AvatarIndex == avatarIndex && _performers[i].Sender == sender)
                    return _performers[i];
            }

            return null;
        }

        // Live performers come first: a server that restarted elsewhere replaces its silent predecessor, however long that one stays.
        private static Performer Better(Performer? first, Performer second)
        {
            if (first == null || (!first.IsLive && (second.IsLive || second.SecondsSinceFrame < first.SecondsSinceFrame)))
                return second;

            return first;
        }

        private void TakePerformers(SourceConnection connection)
        {
            long now = connection.Advance();
            AvatarStream[] streams = connection.Streams.All;
            for (int i = 0; i < streams.Length && _connection == connection; i++)
            {
                if (streams[i].Frames > 0 && !IsGone(streams[i], now) && !Has(streams[i]))
                    Add(streams[i]);
            }

            var sampling = new SamplingSettings(_resample, _delay, _interpolation);
            StagePlacement placement = GetPlacement();
            for (int i = _performers.Count - 1; i >= 0 && i < _performers.Count && _connection == connection; i--)
            {
                _performers[i].Update(now, _idleTimeout, sampling, placement);
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
            var performer = new Performer(stream, new SamplingSettings(_resample, _delay, _interpolation), GetPlacement());
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
