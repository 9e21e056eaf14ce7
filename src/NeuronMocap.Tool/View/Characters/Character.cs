using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>How a character moves now. Immutable.</summary>
/// <param name="Rig">Its skeleton.</param>
/// <param name="Variant">The variant of the performer, which the skeleton was bound for.</param>
/// <param name="Performer">The performer of the stream that it follows; null for none.</param>
/// <param name="PlantsFeet">Whether feet on the ground stay in their place.</param>
internal sealed record CharacterState(CharacterRig Rig, SkeletonVariant Variant, PerformerKey? Performer, bool PlantsFeet);

/// <summary>A character of a page. Thread-safe.</summary>
internal sealed class Character
{
    private readonly Lock _lock = new();
    private readonly string _name;
    private readonly IReadOnlyList<CharacterNode> _nodes;
    private readonly IReadOnlyDictionary<string, int>? _humanoid;
    private readonly float? _lowest;
    private volatile CharacterState _state;

    /// <param name="id">Its number.</param>
    /// <param name="request">What the page says about it.</param>
    /// <exception cref="ApiException">The character cannot be driven.</exception>
    public Character(uint id, NewCharacterJson request)
    {
        (Id, _name) = (id, string.IsNullOrWhiteSpace(request.Name) ? "The character" : request.Name);
        (_nodes, _humanoid, _lowest) = (request.ReadNodes(), request.Humanoid, request.Lowest);
        SkeletonVariant variant = ReadVariant(request.Variant) ?? SkeletonVariant.Neck1;
        _state = new CharacterState(Bind(variant), variant, ReadPerformer(request.Performer), request.Plant ?? true);
    }

    public uint Id { get; }

    public CharacterState State => _state;

    /// <summary>Changes what the request says.</summary>
    /// <exception cref="ApiException">The request is wrong. Nothing is changed.</exception>
    public void Change(CharacterChangeJson request)
    {
        lock (_lock)
        {
            CharacterState now = _state;
            SkeletonVariant variant = ReadVariant(request.Variant) ?? now.Variant;
            _state = new CharacterState(
                variant == now.Variant ? now.Rig : Bind(variant),
                variant,
                request.Performer is null ? now.Performer : ReadPerformer(request.Performer),
                request.Plant ?? now.PlantsFeet);
        }
    }

    public CharacterJson Describe()
    {
        CharacterState now = _state;
        return CharacterJson.Of(Id, now.Rig, now.Variant);
    }

    // The performers of takes have other keys. Their poses are read from the take.
    private static PerformerKey? ReadPerformer(string? key) => PerformerKey.TryParse(key, out PerformerKey performer) ? performer : null;

    private static SkeletonVariant? ReadVariant(string? name) => name switch
    {
        null => null,
        nameof(SkeletonVariant.Neck1) => SkeletonVariant.Neck1,
        nameof(SkeletonVariant.Spine3) => SkeletonVariant.Spine3,
        _ => throw ApiException.BadRequest("The variant is Neck1 or Spine3."),
    };

    private CharacterRig Bind(SkeletonVariant variant)
    {
        try
        {
            return CharacterRig.Create(_nodes, _humanoid, _lowest, variant);
        }
        catch (CharacterException exception)
        {
            throw ApiException.BadRequest($"{_name} cannot follow a performer: {exception.Message}");
        }
    }
}
