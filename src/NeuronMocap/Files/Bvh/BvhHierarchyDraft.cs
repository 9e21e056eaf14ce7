using System.Numerics;

namespace NeuronMocap.Bvh;

// A hierarchy that is being changed. Joints and parents are identified by their old indices.
internal sealed class BvhHierarchyDraft
{
    private const int None = -1;

    private readonly Joint[] _joints;

    public BvhHierarchyDraft(BvhHierarchy hierarchy) => _joints =
    [
        .. hierarchy.Joints.Select(static joint => new Joint
        {
            Name = joint.Name,
            Parent = joint.Parent?.Index ?? None,
            Offset = joint.Offset,
            Channels = [.. joint.Channels],
            EndSite = joint.EndSite,
        }),
    ];

    public Joint this[int index] => _joints[index];

    /// <summary>Creates the hierarchy, depth first. Siblings keep their order.</summary>
    /// <param name="places">The new index of each joint.</param>
    public BvhHierarchy Build(out int[] places)
    {
        ILookup<int, int> children = Enumerable.Range(0, _joints.Length).ToLookup(index => _joints[index].Parent);
        var built = new List<BvhJoint>(_joints.Length);
        places = new int[_joints.Length];
        int channelCount = 0;

        var next = new Stack<int>(children[None].Reverse());
        while (next.Count > 0)
        {
            int index = next.Pop();
            Joint draft = _joints[index];
            places[index] = built.Count;
            BvhJoint? parent = draft.Parent == None ? null : built[places[draft.Parent]];
            var joint = new BvhJoint(draft.Name, built.Count, parent)
            {
                Offset = draft.Offset,
                HasOffset = true,
                EndSite = draft.EndSite,
                FirstChannel = channelCount,
            };
            foreach (BvhChannel channel in draft.Channels)
                joint.AddChannel(channel);

            built.Add(joint);
            channelCount += draft.Channels.Length;
            foreach (int child in children[index].Reverse())
                next.Push(child);
        }

        return new BvhHierarchy(built, channelCount);
    }

    internal sealed class Joint
    {
        public string Name { get; set; } = "";

        public int Parent { get; set; }

        public Vector3 Offset { get; set; }

        public BvhChannel[] Channels { get; set; } = [];

        public Vector3? EndSite { get; set; }
    }
}
