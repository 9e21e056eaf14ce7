using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

public sealed class FootContactTests
{
    [Theory]
    [InlineData(30)]
    [InlineData(60)]
    [InlineData(120)]
    public void The_estimate_agrees_with_the_actors_contacts(int rate)
    {
        var actor = new SyntheticSource(rate);
        var body = SkeletonBody.GetDefault();
        var track = new FootContactTrack();
        var live = new FootContactEstimator();
        List<FootContacts> known = [];
        List<FootContacts> lives = [];
        BoneTransform[] pose = new BoneTransform[59];
        for (int frame = 0; frame < 40 * rate; frame++)
        {
            actor.GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, pose);
            track.Add(pose, body, frame / (double)rate);
            lives.Add(live.Update(pose, body, frame / (double)rate));
            (bool left, bool right) = actor.GetFootContacts(frame);
            known.Add(new FootContacts(left, right));
        }

        FootContacts[] estimated = track.EstimateContacts();
        string figures = FormattableString.Invariant(
            $"{rate} Hz: take {Agreement(known, estimated):P1}, live {Agreement(known, lives):P1}; changes {Changes(known)}, {Changes(estimated)}, {Changes(lives)}");
        TestContext.Current.TestOutputHelper?.WriteLine(figures);
        Assert.True(Agreement(known, estimated) >= 0.93 && Agreement(known, lives) >= 0.91, figures);
        Assert.Equal(Changes(known), Changes(estimated));
        Assert.True(Math.Abs(Changes(known) - Changes(lives)) <= 2, figures);
    }

    [Fact]
    public void Noise_does_not_make_a_contact_flicker()
    {
        // A foot that is lifted and put down once, with noise of two millimetres and of 20 cm/s.
        var random = new Random(3);
        var live = new FootContactEstimator();
        List<FootContacts> contacts = [];
        for (int i = 0; i < 600; i++)
        {
            float Noise() => (random.NextSingle() - 0.5f) * 0.2f;
            float lift = i is > 200 and < 300 ? 15 * MathF.Sin((i - 200) * MathF.PI / 100) : 0;
            contacts.Add(live.Update(new Vector3(Noise(), 5 + Noise(), Noise()), new Vector3(20, 5 + lift + Noise(), lift * 2), i / 120.0));
        }

        Assert.Equal(1 + 1 + 2, Changes(contacts));
        Assert.True(contacts[^1] == new FootContacts(Left: true, Right: true));
        Assert.True(contacts[250] == new FootContacts(Left: true, Right: false));
    }

    [Fact]
    public void Contacts_of_calculation_data_take_precedence()
    {
        float[] values = new float[CalculationFrame.FullValueCount];
        values[336] = 1;
        var frame = new CalculationFrame(new CalculationHeader(), values);
        Assert.Equal(new FootContacts(Left: true, Right: false), frame.FootContacts);

        var estimator = new FootContactEstimator();
        for (int i = 0; i < 10; i++)
            Assert.Equal(frame.FootContacts, estimator.Update(Vector3.Zero, Vector3.Zero, i, frame.FootContacts));

        Assert.Equal(new FootContacts(Left: true, Right: true), estimator.Update(Vector3.Zero, Vector3.Zero, 11));
        estimator.Reset();
        Assert.Equal(default, estimator.Contacts);
    }

    [Fact]
    public void Frames_at_one_time_change_nothing()
    {
        var estimator = new FootContactEstimator();
        estimator.Update(Vector3.Zero, Vector3.Zero, 0);
        estimator.Update(Vector3.Zero, Vector3.Zero, 0.01);
        Assert.Equal(new FootContacts(Left: true, Right: true), estimator.Update(new Vector3(0.1f), new Vector3(0.1f), 0.01));
        Assert.Equal(new FootContacts(Left: true, Right: true), estimator.Update(new Vector3(0.1f), new Vector3(0.1f), 0.02));
    }

    [Theory]
    [InlineData(double.PositiveInfinity)]
    [InlineData(double.NegativeInfinity)]
    [InlineData(double.NaN)]
    public void A_time_that_is_not_finite_does_not_change_the_estimate(double broken)
    {
        var expected = new FootContactEstimator();
        var estimator = new FootContactEstimator();
        Assert.Equal(default, estimator.Update(new Vector3(500), new Vector3(500), broken));
        for (int i = 0; i < 300; i++)
        {
            // A step every half second.
            var foot = new Vector3(0, Math.Max(0, 20 * MathF.Sin(i * MathF.PI / 25)), i);
            FootContacts before = estimator.Contacts;
            if (i % 7 == 5)
                Assert.Equal(before, estimator.Update(new Vector3(500), new Vector3(500), broken));

            Assert.Equal(expected.Update(foot, Vector3.Zero, i / 100.0), estimator.Update(foot, Vector3.Zero, i / 100.0));
        }

        var measured = new FootContacts(Left: true, Right: false);
        Assert.Equal(measured, estimator.Update(Vector3.Zero, Vector3.Zero, broken, measured));
    }

    [Theory]
    [InlineData(200, false)]
    [InlineData(0, true)]
    public void A_frame_without_numbers_changes_no_contact(float speed, bool touches)
    {
        var expected = new FootContacts(Left: touches, Right: touches);
        var track = new FootContactTrack();
        var live = new FootContactEstimator();
        for (int i = 0; i < 21; i++)
        {
            Vector3 foot = i == 10 ? new Vector3(float.NaN) : new Vector3(speed * i / 100, 2, 0);
            track.Add(foot, foot, i / 100.0);
            FootContacts contacts = live.Update(foot, foot, i / 100.0);

            // The first frame has no speed.
            Assert.Equal(i == 0 ? default : expected, contacts);
        }

        Assert.All(track.EstimateContacts(), contacts => Assert.Equal(expected, contacts));
    }

    [Fact]
    public void Takes_of_no_and_one_frame_are_accepted()
    {
        var track = new FootContactTrack();
        Assert.Empty(track.EstimateContacts());
        track.Add(Vector3.Zero, Vector3.UnitY * 20, 0);
        Assert.Equal([new FootContacts(Left: true, Right: false)], track.EstimateContacts());
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        BoneTransform[] pose = new BoneTransform[59];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        ForwardKinematics.ToWorld(pose, pose);
        var estimator = new FootContactEstimator();
        int frame = 0;
        Allocations.AssertNone(() => estimator.Update(pose, SkeletonBody.GetDefault(), frame++ / 60.0));
    }

    internal static double Agreement(IReadOnlyList<FootContacts> one, IReadOnlyList<FootContacts> other) =>
        one.Zip(other, (a, b) => (a.Left == b.Left ? 0.5 : 0) + (a.Right == b.Right ? 0.5 : 0)).Average();

    internal static int Changes(IReadOnlyList<FootContacts> contacts) => contacts.Skip(1)
        .Zip(contacts, (later, earlier) => (later.Left == earlier.Left ? 0 : 1) + (later.Right == earlier.Right ? 0 : 1))
        .Sum();
}
