namespace UnityEngine;

public partial class Transform : Component
{
    private Vector3 _localPosition;
    private Quaternion _localRotation = Quaternion.identity;
    private Vector3 _localScale = Vector3.one;

    [NonSerialized]
    private long _lastChange;

    protected internal Transform()
    {
    }

    public bool hasChanged { get; set; } = true;

    /// <summary>The number of all changes of transforms so far. Physics looks at changes once in a while.</summary>
    internal static long Changes { get; private set; }

    /// <summary>The latest change that moved this transform: its own, or that of a parent.</summary>
    internal long LastChange => Math.Max(_lastChange, Parent?.LastChange ?? 0);

    public Vector3 localPosition
    {
        get
        {
            Check();
            return _localPosition;
        }

        set
        {
            Check();
            if (IsFinite(value.x) && IsFinite(value.y) && IsFinite(value.z))
                _localPosition = value;
            else
                Debug.LogError($"transform.localPosition assign attempt for '{name}' is not valid. Input localPosition is {value}.");

            MarkChanged();
        }
    }

    public Quaternion localRotation
    {
        get
        {
            Check();
            return _localRotation;
        }

        set
        {
            Check();
            _localRotation = Valid(value);
            MarkChanged();
        }
    }

    public Vector3 localScale
    {
        get
        {
            Check();
            return _localScale;
        }

        set
        {
            Check();
            _localScale = value;
            MarkChanged();
        }
    }

    public Vector3 localEulerAngles
    {
        get => localRotation.eulerAngles;
        set => localRotation = Quaternion.Euler(value);
    }

    public Vector3 position
    {
        get
        {
            Check();
            return Parent is null ? _localPosition : Parent.ToWorld(_localPosition);
        }

        set => localPosition = Parent is null ? value : Parent.InverseTransformPoint(value);
    }

    public Quaternion rotation
    {
        get
        {
            Check();
            return GetWorldRotation();
        }

        set => localRotation = Parent is null ? value : Mirror(Quaternion.Inverse(Parent.GetWorldRotation()) * value, Parent.GetSigns());
    }

    public Vector3 eulerAngles
    {
        get => rotation.eulerAngles;
        set => rotation = Quaternion.Euler(value);
    }

    public Vector3 lossyScale
    {
        get
        {
            // The rest of the matrix along the axes after the rotation is removed. A skew is lost.
            Matrix4x4 rest = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
            return new Vector3(rest.m00, rest.m11, rest.m22);
        }
    }

    public Vector3 forward
    {
        get => rotation * Vector3.forward;
        set => rotation = Quaternion.LookRotation(value);
    }

    public Vector3 up
    {
        get => rotation * Vector3.up;
        set => rotation = Quaternion.FromToRotation(Vector3.up, value);
    }

    public Vector3 right
    {
        get => rotation * Vector3.right;
        set => rotation = Quaternion.FromToRotation(Vector3.right, value);
    }

    public Matrix4x4 localToWorldMatrix
    {
        get
        {
            Check();
            var local = Matrix4x4.TRS(_localPosition, _localRotation, _localScale);
            return Parent is null ? local : Parent.localToWorldMatrix * local;
        }
    }

    public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

    public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
    {
        this.position = position;
        this.rotation = rotation;
    }

    public Vector3 TransformPoint(Vector3 position)
    {
        Check();
        return ToWorld(position);
    }

    public Vector3 TransformPoint(float x, float y, float z) => TransformPoint(new Vector3(x, y, z));

    public Vector3 InverseTransformPoint(Vector3 position)
    {
        Check();
        Vector3 inParent = Parent is null ? position : Parent.InverseTransformPoint(position);
        return Divide(Quaternion.Inverse(_localRotation) * (inParent - _localPosition), _localScale);
    }

    public Vector3 TransformDirection(Vector3 direction) => rotation * direction;

    public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

    public Vector3 TransformVector(Vector3 vector) => TransformPoint(vector) - TransformPoint(Vector3.zero);

    public Vector3 InverseTransformVector(Vector3 vector) => InverseTransformPoint(vector) - InverseTransformPoint(Vector3.zero);

    public void Translate(Vector3 translation) => Translate(translation, Space.Self);

    public void Translate(Vector3 translation, Space relativeTo) =>
        position += relativeTo == Space.World ? translation : TransformDirection(translation);

    public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);

    public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle));

    public void Rotate(Vector3 eulers, Space relativeTo)
    {
        var turn = Quaternion.Euler(eulers);
        if (relativeTo == Space.Self)
            localRotation *= turn;
        else
            rotation = turn * rotation;
    }

    public void Rotate(Vector3 axis, float angle) => localRotation *= Quaternion.AngleAxis(angle, axis);

    public void RotateAround(Vector3 point, Vector3 axis, float angle)
    {
        var turn = Quaternion.AngleAxis(angle, axis);
        position = point + (turn * (position - point));
        rotation = turn * rotation;
    }

    public void LookAt(Vector3 worldPosition) => rotation = Quaternion.LookRotation(worldPosition - position);

    public void LookAt(Transform target) => LookAt(target.position);

    private void MarkChanged()
    {
        hasChanged = true;
        _lastChange = ++Changes;
    }

    internal override bool CanDestroy()
    {
        Debug.LogError($"Can't destroy Transform component of '{name}'. If you want to destroy the game object, please call 'Destroy' on the game object instead.");
        return false;
    }

    // Unity accepts only lengths near one unchanged.
    private static Quaternion Valid(Quaternion value) => Quaternion.Normalize(value);

    private static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

    private static float Divide(float value, float by) => by == 0 ? 0 : value / by;

    private static Vector3 Divide(Vector3 value, Vector3 by) => new(Divide(value.x, by.x), Divide(value.y, by.y), Divide(value.z, by.z));

    // A rotation as seen in a mirror: it keeps its direction about axes whose mirror images have the same sign.
    private static Quaternion Mirror(Quaternion q, Vector3 signs) =>
        new(q.x * signs.y * signs.z, q.y * signs.x * signs.z, q.z * signs.x * signs.y, q.w);

    private Vector3 ToWorld(Vector3 point)
    {
        for (Transform? item = this; item is not null; item = item.Parent)
            point = item._localPosition + (item._localRotation * Vector3.Scale(item._localScale, point));

        return point;
    }

    private Quaternion GetWorldRotation()
    {
        Quaternion result = _localRotation;
        for (Transform? item = Parent; item is not null; item = item.Parent)
            result = item._localRotation * Mirror(result, Signs(item._localScale));

        return result;
    }

    private Vector3 GetSigns()
    {
        Vector3 signs = Signs(_localScale);
        return Parent is null ? signs : Vector3.Scale(signs, Parent.GetSigns());
    }

    private static Vector3 Signs(Vector3 scale) => new(Mathf.Sign(scale.x), Mathf.Sign(scale.y), Mathf.Sign(scale.z));
}

public enum Space
{
    World,
    Self,
}
