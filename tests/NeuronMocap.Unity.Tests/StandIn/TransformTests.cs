using static NeuronMocap.Unity.Tests.StandIn.QuaternionTests;
using Random = System.Random;

namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class TransformTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Positions_and_rotations_match_the_matrices()
    {
        var random = new Random(1);
        for (int i = 0; i < 100; i++)
        {
            Transform root = Create("root", null, random, scale: 2);
            Transform middle = Create("middle", root, random, scale: 0.5f);
            Transform leaf = Create("leaf", middle, random, scale: 3);
            Matrix4x4 matrix = Local(root) * Local(middle) * Local(leaf);
            Vector3 point = Point(random);

            Near(matrix.GetPosition(), leaf.position);
            Near(matrix.MultiplyPoint3x4(point), leaf.TransformPoint(point), 1e-3f);
            Near(point, leaf.InverseTransformPoint(leaf.TransformPoint(point)), 1e-3f);
            Assert.InRange(Quaternion.Angle(root.localRotation * middle.localRotation * leaf.localRotation, leaf.rotation), 0, 0.1f);
            Near(Vector3.one * 3, leaf.lossyScale, 1e-3f);
            Object.DestroyImmediate(root.gameObject);
        }
    }

    [Fact]
    public void World_values_read_back()
    {
        var random = new Random(2);
        Transform root = Create("root", null, random, scale: -2);
        Transform middle = Create("middle", root, random, scale: 1);
        Transform leaf = Create("leaf", middle, random, scale: 1);
        Vector3 place = Point(random);
        Quaternion turn = Turn(random);

        leaf.SetPositionAndRotation(place, turn);

        Near(place, leaf.position);
        Assert.InRange(Quaternion.Angle(turn, leaf.rotation), 0, 0.1f);
        Near(leaf.TransformPoint(Vector3.right * -0.5f) - place, turn * Vector3.right, 1e-3f);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_new_parent_keeps_the_world_or_local_position(bool stays)
    {
        var random = new Random(3);
        Transform parent = Create("parent", null, random, scale: 2);
        Transform child = Create("child", null, random, scale: 1);
        (Vector3 position, Quaternion rotation) = (child.position, child.rotation);

        child.SetParent(parent, stays);

        Near(position, stays ? child.position : child.localPosition);
        Assert.InRange(Quaternion.Angle(rotation, stays ? child.rotation : child.localRotation), 0, 0.1f);
        Near(stays ? Vector3.one : Vector3.one * 2, child.lossyScale, 1e-3f);
        Assert.Same(parent, child.parent);
        Assert.Same(child, parent.GetChild(0));

        parent.SetParent(child);
        Assert.Null(parent.parent);
        Assert.Single(ConsoleLog.Problems);
    }

    [Fact]
    public void Children_are_found_by_path_and_enumerated()
    {
        Transform root = new GameObject("root").transform;
        foreach (string name in (string[])["a", "b"])
            new GameObject(name).transform.SetParent(root);

        new GameObject("c").transform.SetParent(root.Find("b"));

        Assert.Equal(["a", "b"], root.Cast<Transform>().Select(static child => child.name));
        Assert.Equal("c", root.Find("b/c")!.name);
        Assert.Null(root.Find("c"));
        Assert.Throws<UnityException>(() => root.GetChild(2));
        Assert.Equal(4, root.GetComponentsInChildren<Transform>().Length);
        root.Find("b")!.gameObject.SetActive(false);
        Assert.Equal(2, root.GetComponentsInChildren<Transform>().Length);
        Assert.Equal(4, root.GetComponentsInChildren<Transform>(true).Length);
    }

    [Fact]
    public void Values_that_are_not_finite_are_refused()
    {
        Transform item = new GameObject("A").transform;

        item.localPosition = new Vector3(float.NaN, 0, 0);

        Assert.Equal(Vector3.zero, item.localPosition);
        Assert.Equal(LogType.Error, Assert.Single(ConsoleLog.Problems).Type);
    }

    private static Transform Create(string name, Transform? parent, Random random, float scale)
    {
        Transform item = new GameObject(name).transform;
        item.SetParent(parent, false);
        item.localPosition = Point(random);
        item.localRotation = Turn(random);
        item.localScale = Vector3.one * scale;
        return item;
    }

    private static Matrix4x4 Local(Transform item) => Matrix4x4.TRS(item.localPosition, item.localRotation, item.localScale);
}
