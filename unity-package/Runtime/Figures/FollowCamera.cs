#nullable enable

using NeuronMocap.Retargeting;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>Moves its object with a figure and looks at the figure, so that a camera on this object keeps the figure in the picture.</summary>
    [AddComponentMenu("NeuronMocap/Follow Camera")]
    [HelpURL(HelpPage.Components + "#follow-camera")]
    [DefaultExecutionOrder(310)]
    [DisallowMultipleComponent]
    public sealed class FollowCamera : MonoBehaviour
    {
        private const float SearchPeriod = 1; // s

        [SerializeField]
        [Tooltip("What to follow: the hips of a Humanoid character, or of the figure whose driver is on the target, above it or below it. Otherwise the "
            + "target's own position. Empty: the camera stays.")]
        private Transform? _target;

        [SerializeField]
        [Tooltip("Position relative to the target, in metres along the axes of the scene.")]
        private Vector3 _viewpoint = new Vector3(1.2f, 0.6f, 3.4f);

        [SerializeField]
        [Range(0, 5)]
        [Tooltip("Time constant of the camera's movement, in seconds. 0: follow immediately.")]
        private float _followTime = 0.4f;

        private Vector3 _focus;
        private bool _hasFocus;
        private Transform? _seenTarget;
        private FigureDriver? _driver;
        private FigureBuilder? _builder;
        private Animator? _animator;
        private float _searchTime;

        /// <summary>
        /// Gets or sets the figure to follow. The camera follows the hips of a Humanoid character, or of the figure whose
        /// <see cref="FigureDriver"/> is on this object, above it or below it. Otherwise it follows the object's own position. Null: the
        /// camera stays.
        /// </summary>
        public Transform? Target
        {
            get => _target;
            set => _target = value;
        }

        /// <summary>Gets or sets the position relative to the target, in metres along the axes of the scene.</summary>
        public Vector3 Viewpoint
        {
            get => _viewpoint;
            set => _viewpoint = value;
        }

        /// <summary>
        /// Gets or sets the time constant of the camera's movement, in seconds. It is the time in which the distance to a target that has
        /// moved falls to 37 %. 0: follow immediately. Game time that is paused or slow does not change it.
        /// </summary>
        public float FollowTime
        {
            get => _followTime;
            set => _followTime = Mathf.Clamp(value, 0, 5);
        }

        /// <summary>Moves to the viewpoint at once, in edit mode, too.</summary>
        public void Snap()
        {
            _hasFocus = false;
            Follow();
        }

        private void OnEnable() => _hasFocus = false;

        private void LateUpdate() => Follow();

        private void Follow()
        {
            if (_target == null)
                return;

            Vector3 target = FindFocus(_target);
            float part = _hasFocus && _followTime > 0 ? 1 - Mathf.Exp(-FrameTime.Delta / _followTime) : 1;
            _focus = Vector3.Lerp(_focus, target, part);
            _hasFocus = true;
            transform.position = _focus + _viewpoint;
            transform.LookAt(_focus);
        }

        // The object of a figure can stay in place while the hips walk.
        private Vector3 FindFocus(Transform target)
        {
            if (_seenTarget != target || (_driver == null && Time.unscaledTime >= _searchTime))
                Search(target);

            if (_driver != null && _driver.TryGetBonePose(HumanoidBone.Hips, out Vector3 driven, out _))
                return driven;
            if (_builder != null)
                return _builder.Figure is { IsDestroyed: false } figure ? figure.GetBone(Bone.Hips).position : target.position + Vector3.up;

            Transform? hips = _animator != null && _animator.isHuman ? _animator.GetBoneTransform(HumanBodyBones.Hips) : null;
            return hips != null ? hips.position : target.position;
        }

        // Figures of a spawner come and go.
        private void Search(Transform target)
        {
            _seenTarget = target;
            _searchTime = Time.unscaledTime + SearchPeriod;
            _driver = target.GetComponentInParent<FigureDriver>();
            if (_driver == null)
                _driver = target.GetComponentInChildren<FigureDriver>();

            (_driver != null ? _driver.transform : target).TryGetComponent(out _builder);
            target.TryGetComponent(out _animator);
        }
    }
}
