namespace UnityEngine.Playables;

public interface IPlayableAsset
{
    double duration { get; }

    Playable CreatePlayable(PlayableGraph graph, GameObject owner);
}

public abstract class PlayableAsset : ScriptableObject, IPlayableAsset
{
    /// <summary>Gets the duration in seconds. Unity's default is 5.</summary>
    public virtual double duration => 5;

    public abstract Playable CreatePlayable(PlayableGraph graph, GameObject owner);
}

/// <summary>Evaluates a playable asset at a time, in play mode and in edit mode alike. It does not run by itself.</summary>
public class PlayableDirector : Behaviour
{
    [NonSerialized]
    private readonly Dictionary<Object, Object?> _bindings = [];

    [NonSerialized]
    private PlayableGraph _graph;

    [NonSerialized]
    private PlayableNode? _root;

    public PlayableAsset? playableAsset { get; set; }

    public double time { get; set; }

    public Object? GetGenericBinding(Object key) => _bindings.GetValueOrDefault(key);

    public void SetGenericBinding(Object key, Object? value) => _bindings[key] = value;

    public void RebuildGraph()
    {
        Stop();
        _graph = PlayableGraph.Create();
        _root = playableAsset!.CreatePlayable(_graph, gameObject).GetHandle().Node;
    }

    /// <summary>Evaluates the asset at the time, and creates its playables before the first time.</summary>
    public void Evaluate()
    {
        if (_root is null)
            RebuildGraph();

        _root!.Time = time;
        _root.Prepare();
        _root.Process(null);
    }

    public void Stop()
    {
        if (_graph.IsValid())
            _graph.Destroy();

        (_graph, _root) = (default, null);
    }

    internal override void DestroyNow()
    {
        Stop();
        base.DestroyNow();
    }
}
