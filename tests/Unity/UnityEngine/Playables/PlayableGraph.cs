namespace UnityEngine.Playables;

public readonly struct PlayableGraph
{
    private readonly List<PlayableNode>? _nodes;

    private PlayableGraph(List<PlayableNode> nodes) => _nodes = nodes;

    public static PlayableGraph Create() => new([]);

    public bool IsValid() => _nodes is not null;

    public int GetPlayableCount() => _nodes!.Count;

    public void Destroy()
    {
        foreach (PlayableNode node in _nodes!)
        {
            node.IsDestroyed = true;
            node.Behaviour.OnPlayableDestroy(new Playable(node));
        }

        _nodes.Clear();
    }

    internal void Add(PlayableNode node)
    {
        _nodes!.Add(node);
        node.Behaviour.OnPlayableCreate(new Playable(node));
    }
}

/// <summary>A playable of a graph: a behaviour, its local time, and weighted inputs.</summary>
internal sealed class PlayableNode(PlayableBehaviour behaviour, int inputCount)
{
    public PlayableBehaviour Behaviour { get; } = behaviour;

    public PlayableNode?[] Inputs { get; } = new PlayableNode?[inputCount];

    public float[] Weights { get; } = new float[inputCount];

    public double Time { get; set; }

    public bool IsDestroyed { get; set; }

    /// <summary>The object that this playable and its inputs work on.</summary>
    public Func<object?>? PlayerData { get; set; }

    /// <summary>Parents prepare their inputs, and inputs without weight are left out.</summary>
    public void Prepare()
    {
        Behaviour.PrepareFrame(new Playable(this), default);
        for (int i = 0; i < Inputs.Length; i++)
        {
            if (Weights[i] > 0)
                Inputs[i]?.Prepare();
        }
    }

    /// <summary>Inputs are processed before their parents.</summary>
    public void Process(object? playerData)
    {
        object? data = PlayerData is null ? playerData : PlayerData();
        for (int i = 0; i < Inputs.Length; i++)
        {
            if (Weights[i] > 0)
                Inputs[i]?.Process(data);
        }

        Behaviour.ProcessFrame(new Playable(this), default, data);
    }
}
