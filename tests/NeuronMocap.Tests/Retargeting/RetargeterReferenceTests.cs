using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

// Thousands of characters and actors without anything in common.
public sealed class RetargeterReferenceTests
{
    private const double MostRadians = 1e-5;
    private const double MostMetres = 1e-4;

    [Theory]
    [InlineData(RigScales.None)]
    [InlineData(RigScales.Signs)]
    [InlineData(RigScales.Uniform)]
    [InlineData(RigScales.Sheared)]
    internal void Every_node_is_where_the_reference_has_it(RigScales scales)
    {
        for (int seed = 0; seed < 500; seed++)
        {
            var random = new Random(seed);
            var character = new RandomRig(seed, scales);
            SkeletonBody body = RandomPoses.Body(random);
            BoneTransform[] pose = RandomPoses.Pose(random);
            BoneTransform? reference = random.Next(2) == 0 ? null : new BoneTransform(new Vector3(40, -30, 20), RandomPoses.Turn(random));
            TargetRig rig = character.Create();
            var result = new RetargetedPose(rig);
            Assert.True(new Retargeter(rig, body).TryRetarget(pose, result, reference));
            result.UpdateWorld();

            var expected = new ReferenceRetargeter(character.Nodes, ExpectedMap.Sources(character, body.Variant), character.Facing);
            expected.Retarget(pose, body, reference);
            AssertSame(expected, result, $"seed {seed}, {scales}");
        }
    }

    // The basic rule, without a hierarchy: a bone turns away from its rest rotation as the actor's bone does.
    [Fact]
    public void Every_mapped_bone_has_the_actors_world_rotation()
    {
        for (int seed = 0; seed < 300; seed++)
        {
            var random = new Random(seed);
            var character = new RandomRig(seed, (RigScales)(seed % 4));
            SkeletonBody body = RandomPoses.Body(random);
            BoneTransform[] pose = RandomPoses.Pose(random);
            TargetRig rig = TargetRig.CreateHumanoid(character.Nodes, character.NodeOf, Quaternion.Identity);
            var result = new RetargetedPose(rig);
            Assert.True(new Retargeter(rig, body).TryRetarget(pose, result));
            result.UpdateWorld();

            Affine[] turns = ReferenceRetargeter.SourceTurns(pose, body.Variant);
            Bone?[] sources = ExpectedMap.Sources(character, body.Variant);
            for (int node = 0; node < sources.Length; node++)
            {
                if (sources[node] is not { } source)
                    continue;

                Affine turn = Affine.Turned(result.WorldRotations[node]) * Affine.Turned(rig.RestRotations[node]).Back();
                Assert.True(turn.AngleTo(turns[(int)source]) < MostRadians, $"seed {seed}: {source} to {character.Nodes[node].Name}");
            }
        }
    }

    internal static void AssertSame(ReferenceRetargeter expected, RetargetedPose actual, string where)
    {
        double[] hips = [actual.HipsLocalPosition.X, actual.HipsLocalPosition.Y, actual.HipsLocalPosition.Z];
        double[][] places = expected.PlacesOf([.. actual.LocalRotations.ToArray().Select(Affine.Turned)], hips);
        for (int node = 0; node < actual.Rig.Nodes.Length; node++)
        {
            string what = $"{where}, node {node} {actual.Rig.Nodes[node].Name}";
            Check(expected.LocalTurns[node].AngleTo(actual.LocalRotations[node]), MostRadians, what, "local rotation");
            Check(expected.WorldTurns[node].AngleTo(actual.WorldRotations[node]), MostRadians, what, "rotation");
            Vector3 place = actual.WorldPositions[node];
            Check(Distance(expected.WorldPlaces[node], [place.X, place.Y, place.Z]), MostMetres, what, "place");
            Check(Distance(expected.WorldPlaces[node], places[node]), MostMetres, what, "place by local values");
            Check(Math.Abs(1 - actual.LocalRotations[node].Length()), 1e-6, what, "length");
        }
    }

    private static void Check(double error, double limit, string where, string what) => Assert.True(error <= limit, $"{where}: {what} off by {error:e2}");

    private static double Distance(double[] one, double[] other) => Math.Sqrt(one.Zip(other, (a, b) => (a - b) * (a - b)).Sum());
}
