#nullable enable

using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace NeuronMocap.Unity.EditorTools
{
    // A performer in words, for the lists of the inspector and the window.
    internal sealed class PerformerRow
    {
        public PerformerRow(Performer performer, AvatarStatistics? figures)
        {
            Performer = performer;
            Name = string.IsNullOrEmpty(performer.Name) ? "(no name)" : performer.Name;
            State = performer.IsLive ? "live" : $"no frame for {Number(performer.SecondsSinceFrame, "0")} s";
            Severity = performer.IsLive ? Severity.Good : Severity.Warning;
            if (figures is not { } some)
                return;

            FrameRate = performer.IsLive ? $"{Number(some.FrameRate, "0.0")} /s" : "-";
            Lost = some.Frames + some.Lost > 0 ? Losses(some.Lost, some.Frames) : "-";
            Jitter = $"{Number(some.Jitter.TotalMilliseconds, "0.0")} ms";
        }

        public Performer Performer { get; }

        public string Name { get; }

        public int AvatarIndex => Performer.AvatarIndex;

        public string State { get; }

        public Severity Severity { get; }

        public string FrameRate { get; } = "-";

        public string Lost { get; } = "-";

        public string Jitter { get; } = "-";

        public string Summary => $"{State}, {FrameRate}, lost {Lost}, jitter {Jitter}";

        public static IReadOnlyList<PerformerRow> ListOf(MocapSource source)
        {
            IReadOnlyList<AvatarStatistics> figures = source.Reader?.GetAvatarStatistics() ?? Array.Empty<AvatarStatistics>();
            return source.Performers.Select(performer => new PerformerRow(performer, Find(figures, performer))).ToArray();
        }

        public static string Losses(long lost, long received) =>
            lost == 0 ? "0" : $"{lost} ({Number(100.0 * lost / (lost + received), "0.00")} %)";

        public static string Number(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

        private static AvatarStatistics? Find(IReadOnlyList<AvatarStatistics> figures, Performer performer)
        {
            foreach (AvatarStatistics some in figures)
            {
                if (some.Kind == PacketKind.Motion && some.AvatarIndex == performer.AvatarIndex && some.Sender == performer.Sender)
                    return some;
            }

            return null;
        }
    }
}
