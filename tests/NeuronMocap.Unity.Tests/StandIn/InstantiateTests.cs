namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class InstantiateTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void A_copy_has_exactly_the_serialized_fields()
    {
        GameObject prefab = _loop.CreatePrefab("Figure", static root =>
        {
            Transform child = new GameObject("child").transform;
            child.SetParent(root.transform);
            child.localPosition = new Vector3(1, 2, 3);
            root.AddComponent<Holder>().Fill(child);
        });
        Holder original = prefab.GetComponent<Holder>();
        Assert.Equal(0, original.Awoken);

        Holder copy = Object.Instantiate(original, new Vector3(5, 0, 0), Quaternion.identity);

        Assert.Equal("Figure(Clone)", copy.name);
        Assert.Equal(1, copy.Awoken);
        Assert.Equal((7, "text", 0), (copy.Shown, copy.Kept, copy.Forgotten));
        Assert.Same(copy.transform.Find("child"), copy.Target);
        Assert.NotSame(original.Target, copy.Target);
        Assert.Equal([1, 2], copy.List);
        Assert.NotSame(original.List, copy.List);
        Assert.Equal(4, copy.Part!.Value);
        Assert.NotSame(original.Part, copy.Part);
        Assert.Equal(new Vector3(6, 2, 3), copy.Target!.position);
        Assert.False(prefab.scene.IsValid());
        Assert.True(copy.gameObject.scene.IsValid());
    }

    [Fact]
    public void A_copy_of_an_inactive_object_is_inactive()
    {
        GameObject prefab = _loop.CreatePrefab("Figure", static root => root.AddComponent<Holder>());
        prefab.SetActive(false);

        GameObject copy = Object.Instantiate(prefab);
        Assert.Equal(0, copy.GetComponent<Holder>().Awoken);

        copy.SetActive(true);
        Assert.Equal(1, copy.GetComponent<Holder>().Awoken);
    }

    private sealed class Holder : MonoBehaviour
    {
        public int Shown;
        public List<int> List = [];
        public Transform? Target;
        public PartOfIt? Part;

        [NonSerialized]
        public int Forgotten;

        [SerializeField]
        private string _kept = "";

        public string Kept => _kept;

        public int Awoken { get; private set; }

        public void Fill(Transform target)
        {
            (Shown, _kept, Forgotten, Target) = (7, "text", 9, target);
            List.AddRange([1, 2]);
            Part = new PartOfIt { Value = 4 };
        }

        private void Awake() => Awoken++;
    }

    [Serializable]
    private sealed class PartOfIt
    {
        public int Value;
    }
}
