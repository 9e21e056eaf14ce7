using System.Globalization;
using System.Numerics;
using NeuronMocap.Motion;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class FootContactTests
{
    // Measured: 97.9, 96.2 and 99.3 % for whole takes, 96.9, 95.1 and 99.1 % live. The bounds have a margin.
    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc", 0.93, 0.91)]
    [InlineData("hiphop_up_Char00.calc", 0.95, 0.94)]
    [InlineData("salsa_left_Char00.calc", 0.98, 0.975)]
    public void The_estimate_agrees_with_the_recorded_contacts(string file, double leastOfTake, double leastLive)
    {
        List<(Vector3 Left, Vector3 Right, FootContacts Recorded)> frames = ReadFeet(Fixtures.Require("calc", file));
        var track = new FootContactTrack();
        var live = new FootContactEstimator();
        List<FootContacts> lives = [];
        for (int i = 0; i < frames.Count; i++)
        {
            track.Add(frames[i].Left, frames[i].Right, i / 120.0);
            lives.Add(live.Update(frames[i].Left, frames[i].Right, i / 120.0));
        }

        FootContacts[] recorded = [.. frames.Select(frame => frame.Recorded)];
        FootContacts[] estimated = track.EstimateContacts();
        string figures = FormattableString.Invariant(
            $"{frames.Count} frames: take {NeuronMocap.Tests.Motion.FootContactTests.Agreement(recorded, estimated):P1}, live {NeuronMocap.Tests.Motion.FootContactTests.Agreement(recorded, lives):P1}; changes {NeuronMocap.Tests.Motion.FootContactTests.Changes(recorded)}, {NeuronMocap.Tests.Motion.FootContactTests.Changes(estimated)}, {NeuronMocap.Tests.Motion.FootContactTests.Changes(lives)}");
        TestContext.Current.TestOutputHelper?.WriteLine(figures);
        Assert.True(NeuronMocap.Tests.Motion.FootContactTests.Agreement(recorded, estimated) >= leastOfTake && NeuronMocap.Tests.Motion.FootContactTests.Agreement(recorded, lives) >= leastLive, figures);
        Assert.True(NeuronMocap.Tests.Motion.FootContactTests.Changes(estimated) <= NeuronMocap.Tests.Motion.FootContactTests.Changes(recorded) + 2, figures);
    }

    // Metres with Z down. Bones are in the order of Appendix C, where the right foot is the fourth and the left foot the seventh.
    private static List<(Vector3 Left, Vector3 Right, FootContacts Recorded)> ReadFeet(string path)
    {
        List<(Vector3, Vector3, FootContacts)> frames = [];
        foreach (string line in File.ReadLines(path))
        {
            float[] values = [.. line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Select(word => float.Parse(word, CultureInfo.InvariantCulture))];
            if (values.Length == 0)
                continue;

            Vector3 At(int bone) => new Vector3(values[bone * 16], -values[(bone * 16) + 2], values[(bone * 16) + 1]) * 100;
            frames.Add((At(6), At(3), new FootContacts(values[336] > 0.5f, values[337] > 0.5f)));
        }

        return frames;
    }
}
