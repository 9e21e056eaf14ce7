using UnityEngine.StandIn;

namespace UnityEngine;

public class Animator : Behaviour
{
    private static readonly List<Animator> _animated = [];

    private Avatar? _avatar;
    private HumanBones? _bones;
    private bool _isFound;

    public Avatar? avatar
    {
        get
        {
            Check();
            return _avatar;
        }

        set
        {
            Check();
            _avatar = value;
            Rebind();
        }
    }

    public bool isHuman => avatar is { isHuman: true, isValid: true };

    public bool hasRootMotion => false;

    public bool applyRootMotion { get; set; }

    public float humanScale => isHuman ? Bones!.HipsHeight : 1;

    public float speed { get; set; } = 1;

    public RuntimeAnimatorController? runtimeAnimatorController { get; set; }

    public AnimatorUpdateMode updateMode { get; set; }

    public AnimatorCullingMode cullingMode { get; set; }

    public bool isInitialized => isActiveAndEnabled;

    public Vector3 rootPosition
    {
        get => transform.position;
        set => transform.position = value;
    }

    public Quaternion rootRotation
    {
        get => transform.rotation;
        set => transform.rotation = value;
    }

    public float leftFeetBottomHeight => LimbGoals.FootHeight;

    public float rightFeetBottomHeight => LimbGoals.FootHeight;

    /// <summary>
    /// The work of a controller: it writes everything that it animates. It runs between Update and LateUpdate, or after each FixedUpdate
    /// (AnimatePhysics), and not while all renderers below are out of sight, if the Animator is culled.
    /// </summary>
    internal Action? Animating
    {
        get;

        set
        {
            field = value;
            _animated.Remove(this);
            if (value is not null)
                _animated.Add(this);
        }
    }

    private bool IsCulled => cullingMode != AnimatorCullingMode.AlwaysAnimate
        && GetComponentsInChildren<Renderer>() is { Length: > 0 } renderers && !renderers.Any(static renderer => renderer.isVisible);

    private HumanBones? Bones => _bones ??= _avatar is { isHuman: true, isValid: true } ? new HumanBones(_avatar, transform) : null;

    /// <returns>The transform, or null if the bone is not mapped.</returns>
    /// <exception cref="InvalidOperationException">The avatar is null or not human.</exception>
    public Transform? GetBoneTransform(HumanBodyBones humanBoneId)
    {
        Check();
        if (humanBoneId is < HumanBodyBones.Hips or >= HumanBodyBones.LastBone)
            throw new IndexOutOfRangeException("humanBoneId must be between 0 and " + HumanBodyBones.LastBone);

        if (_avatar == null)
            throw new InvalidOperationException("Avatar is null.");

        if (!_avatar.isValid || !_avatar.isHuman)
            throw new InvalidOperationException("Avatar is not valid or not of type humanoid.");

        // An Animator finds its bones when its object first becomes active.
        _isFound |= gameObject.activeInHierarchy || gameObject.IsAsset;
        if (!_isFound)
            return null;

        Transform? bone = Bones?.Get(humanBoneId);
        return bone != null ? bone : null;
    }

    public void Rebind()
    {
        Check();
        _bones = null;
    }

    public void Update(float deltaTime) => Animating?.Invoke();

    internal static void RunAll(bool inPhysics)
    {
        _animated.RemoveAll(static animator => animator.IsDestroyed);
        foreach (Animator animator in _animated)
        {
            if (animator.IsRunning && (animator.updateMode == AnimatorUpdateMode.AnimatePhysics) == inPhysics && !animator.IsCulled)
                animator.Animating!();
        }
    }

    public void SetFloat(string name, float value)
    {
    }

    public void SetBool(string name, bool value)
    {
    }

    public void SetTrigger(string name)
    {
    }
}

public class RuntimeAnimatorController : Object
{
}

public enum AnimatorUpdateMode
{
    Normal,
    AnimatePhysics,
    UnscaledTime,
}

public enum AnimatorCullingMode
{
    AlwaysAnimate,
    CullUpdateTransforms,
    CullCompletely,
}
