using System.Numerics;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Tests.Retargeting;

public sealed class TwoBoneIkTests
{
    [Fact]
    public void A_reachable_target_is_reached_and_the_lengths_are_kept()
    {
        var random = new Random(1);
        for (int i = 0; i < 5000; i++)
        {
            Limb limb = Limb.Random(random);
            Vector3 target = limb.Root + (random.Direction() * random.Range(Math.Abs(limb.Upper - limb.Lower), limb.Upper + limb.Lower));

            TwoBoneSolution solution = limb.Solve(target);

            (Vector3 middle, Vector3 end) = limb.Turned(solution);
            Assert.True(Vector3.Distance(end, target) < 3e-5f, $"Case {i}: {Vector3.Distance(end, target)} m off.");
            Assert.True(Vector3.Distance(end, solution.End) < 3e-5f && Vector3.Distance(middle, solution.Middle) < 3e-5f, $"Case {i}");
            Assert.Equal(limb.Upper, Vector3.Distance(limb.Root, solution.Middle), 1e-5f);
            Assert.Equal(limb.Lower, Vector3.Distance(solution.Middle, solution.End), 1e-5f);
        }
    }

    [Fact]
    public void A_bend_keeps_its_direction()
    {
        var random = new Random(2);
        for (int i = 0; i < 2000; i++)
        {
            Limb limb = Limb.Random(random, leastBend: 0.1f);
            float distance = random.Range(0.3f, 0.98f) * (limb.Upper + limb.Lower);
            Vector3 axis = Vector3.Normalize(limb.End - limb.Root);

            // For a target on the same line, the knee stays in its plane and on its side.
            Vector3 before = Aside(limb.Middle - limb.Root, axis);
            Vector3 after = Aside(limb.Solve(limb.Root + (axis * distance)).Middle - limb.Root, axis);
            Assert.True(distance < Math.Abs(limb.Upper - limb.Lower) || Angle(before, after) < 2e-3f, $"Case {i}: {Angle(before, after)} rad");
        }
    }

    [Fact]
    public void A_target_at_the_end_turns_nothing()
    {
        var random = new Random(3);
        for (int i = 0; i < 2000; i++)
        {
            Limb limb = Limb.Random(random, leastBend: 0.05f);
            TwoBoneSolution solution = limb.Solve(limb.End);
            Assert.True(Angle(solution.Upper) < 1e-4f && Angle(solution.Lower) < 1e-4f, $"Case {i}: {solution}");
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-0.002f)]
    [InlineData(-0.05f)]
    public void A_straight_limb_and_one_bent_backwards_bend_forward(float bend)
    {
        var limb = new Limb(new Vector3(0, 1, 0), new Vector3(0, 0.5f, bend), Vector3.Zero, Vector3.UnitZ);
        TwoBoneSolution solution = limb.Solve(new Vector3(0, 0.1f, 0));
        Assert.True(solution.Middle.Z > 0.2f, solution.ToString());
        Assert.Equal(0, solution.Middle.X, 1e-6f);
    }

    [Fact]
    public void The_turns_change_gradually_while_a_limb_straightens_and_bends_to_the_other_side()
    {
        // The knee crosses the line from hip to ankle in steps of half a millimetre, slightly aside, like a real knee.
        Vector3? last = null;
        float largest = 0;
        for (float bend = 0.05f; bend > -0.05f; bend -= 0.0005f)
        {
            var limb = new Limb(new Vector3(0, 1, 0), new Vector3(0.004f, 0.5f, bend), Vector3.Zero, Vector3.UnitZ);
            Vector3 middle = limb.Solve(new Vector3(0.1f, 0.06f, 0.1f)).Middle;
            largest = Math.Max(largest, last is { } before ? Vector3.Distance(before, middle) : 0);
            last = middle;
        }

        // For a knee that is 0.23 m aside.
        Assert.True(largest < 0.015f, $"{largest} m");
    }

    [Fact]
    public void A_limb_stretches_towards_an_unreachable_target()
    {
        var random = new Random(4);
        for (int i = 0; i < 1000; i++)
        {
            Limb limb = Limb.Random(random);
            Vector3 way = random.Direction();
            TwoBoneSolution solution = limb.Solve(limb.Root + (way * ((limb.Upper + limb.Lower) * random.Range(1, 100))));
            Assert.True(Vector3.Distance(limb.Root + (way * (limb.Upper + limb.Lower)), limb.Turned(solution).End) < 1e-4f, $"Case {i}");
        }
    }

    [Fact]
    public void A_limb_folds_towards_a_target_that_is_too_near()
    {
        var limb = new Limb(new Vector3(0, 1, 0), new Vector3(0, 0.4f, 0.01f), Vector3.Zero, Vector3.UnitZ);
        Assert.Equal(limb.Upper - limb.Lower, Vector3.Distance(limb.Root, limb.Turned(limb.Solve(limb.Root)).End), 1e-4f);
        Assert.Equal(limb.Upper - limb.Lower, Vector3.Distance(limb.Root, limb.Turned(limb.Solve(new Vector3(0, 0.99f, 0))).End), 1e-4f);
    }

    public static TheoryData<Vector3, Vector3, Vector3, Vector3, Vector3> Impossible => new()
    {
        { Vector3.One, Vector3.One, Vector3.One, Vector3.Zero, Vector3.UnitZ },
        { Vector3.One, Vector3.One, Vector3.Zero, Vector3.Zero, Vector3.UnitZ },
        { Vector3.One, Vector3.Zero, Vector3.Zero, Vector3.One, Vector3.UnitZ },
        { Vector3.UnitY, Vector3.Zero, -Vector3.UnitY, new Vector3(float.NaN), Vector3.UnitZ },
        { Vector3.UnitY, Vector3.Zero, new Vector3(float.PositiveInfinity), Vector3.Zero, Vector3.UnitZ },
        { Vector3.UnitY, Vector3.Zero, -Vector3.UnitY, Vector3.Zero, new Vector3(float.NaN) },
    };

    [Theory, MemberData(nameof(Impossible))]
    public void A_degenerate_limb_is_left_alone(Vector3 root, Vector3 middle, Vector3 end, Vector3 target, Vector3 forward)
    {
        TwoBoneSolution solution = TwoBoneIk.Solve(root, middle, end, target, forward);
        Assert.Equal((Quaternion.Identity, Quaternion.Identity), (solution.Upper, solution.Lower));
    }

    // Combinations of parallel and perpendicular directions, where formulas could divide by zero.
    [Fact]
    public void Results_are_always_finite()
    {
        Vector3[] places = [Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitX, -Vector3.UnitY, -Vector3.UnitZ, 2 * Vector3.UnitY, new(1e-5f)];
        foreach (Vector3 middle in places)
        {
            foreach (Vector3 end in places)
            {
                foreach (Vector3 target in places)
                {
                    foreach (Vector3 forward in places)
                    {
                        TwoBoneSolution solution = TwoBoneIk.Solve(Vector3.Zero, middle, end, target, forward);
                        Assert.Equal(1, solution.Upper.Length(), 1e-5f);
                        Assert.Equal(1, solution.Lower.Length(), 1e-5f);
                        Assert.True(float.IsFinite((solution.End + solution.Middle).Length()), $"{middle} {end} {target} {forward}");
                    }
                }
            }
        }
    }

    private static Vector3 Aside(Vector3 vector, Vector3 axis) => vector - (axis * Vector3.Dot(vector, axis));

    private static float Angle(Vector3 one, Vector3 other) => MathF.Atan2(Vector3.Cross(one, other).Length(), Vector3.Dot(one, other));

    private static float Angle(Quaternion turn) => 2 * MathF.Asin(Math.Min(1, new Vector3(turn.X, turn.Y, turn.Z).Length()));

    private readonly record struct Limb(Vector3 Root, Vector3 Middle, Vector3 End, Vector3 Forward)
    {
        public float Upper => Vector3.Distance(Root, Middle);

        public float Lower => Vector3.Distance(Middle, End);

        // Bent by at least that angle. Forward is the direction of the knee.
        public static Limb Random(Random random, float leastBend = 0)
        {
            Vector3 root = random.InBox(2);
            Vector3 along = random.Direction();
            Vector3 forward = Vector3.Normalize(Aside(random.Direction(), along));
            float upper = random.Range(0.2f, 0.6f);
            float lower = random.Range(0.2f, 0.6f);
            float bend = random.Range(leastBend, 2.5f);
            Vector3 middle = root + (along * upper);
            Vector3 end = middle + (((along * MathF.Cos(bend)) - (forward * MathF.Sin(bend))) * lower);
            return new Limb(root, middle, end, forward);
        }

        public TwoBoneSolution Solve(Vector3 target) => TwoBoneIk.Solve(Root, Middle, End, target, Forward);

        public (Vector3 Middle, Vector3 End) Turned(TwoBoneSolution solution)
        {
            Vector3 middle = Root + Vector3.Transform(Middle - Root, solution.Upper);
            return (middle, middle + Vector3.Transform(End - Middle, solution.Lower));
        }
    }
}
