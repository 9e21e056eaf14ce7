#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The work of each rendered frame. For [NonSerialized], see MocapSource.
    public abstract partial class FigureDriver
    {
        private const float RebindPeriod = 1; // s

        [NonSerialized]
        private FigureRig? _rig;

        [NonSerialized]
        private string? _rigProblem;

        [NonSerialized]
        private float _rebindTime;

        [NonSerialized]
        private int _body;

        [NonSerialized]
        private int _placement;

        [NonSerialized]
        private Performer? _retargeted;

        [NonSerialized]
        private bool _hasPose;

        [NonSerialized]
        private float _presence = 1;

        [NonSerialized]
        private IdleBlend? _idle;

        // The performer that a spawner has chosen. Its number is not enough, because two computers that send to the same UDP port may use the same one.
        [NonSerialized]
        private (MocapSource? Source, int Index, int Sender)? _assigned;

        // Whether the figure stands with arms down, instead of keeping its last pose. The way there and back takes the idle blend time.
        internal bool IsStanding { get; set; }

        private protected FigureRig? Rig => _rig;

        // Null without an assigned performer, and after its source, the choice or the number was changed.
        private int? AssignedSender => _assigned is { } assigned && _source == assigned.Source && _performerChoice == PerformerChoice.ByIndex
            && _performerIndex == assigned.Index ? assigned.Sender : (int?)null;

        internal void Assign(MocapSource? source, Performer performer)
        {
            (_source, _performerChoice, _performerIndex) = (source, PerformerChoice.ByIndex, performer.AvatarIndex);
            _assigned = (source, performer.AvatarIndex, performer.Sender);
        }

        // Captures the figure and its rest pose, or describes the problem.
        private protected abstract FigureRig? CreateRig(out string problem);

        // Whether the rig belongs to the figure that the settings name, and the figure still exists.
        private protected abstract bool IsBound { get; }

        private protected abstract void CopyBoneWeights(BoneWeights weights);

        private protected void Awake() => TryBind();

        private protected void OnEnable()
        {
            _rigProblem = null;
            _presence = 1;
        }

        private protected void OnDisable()
        {
            IsDriving = false;
            Performer = null;
            ActiveSource = null;
            _retargeted = null;
            _hasPose = false;
            ForgetController();
            _rig?.Writer.End();
            _rig?.Bodies.End();
            EndSteps();
        }

        private protected virtual void OnValidate() => _rigProblem = null;

        private void Update()
        {
            if (_driveTime == DriveTime.Update)
                Drive();
            else if (_driveTime == DriveTime.Physics)
                FollowClock();
        }

        private void LateUpdate()
        {
            if (_driveTime == DriveTime.LateUpdate)
                Drive();

            KeepPose();
        }

        private void Drive()
        {
            IsDriving = false;
            if (IsPosed)
            {
                Problem = string.Empty;
                return;
            }

            // Also without a figure, because a figure may be built only when its performer is known.
            Performer = FindPerformer();
            if (!TryBind())
            {
                Problem = _rigProblem!;
                return;
            }

            bool isLive = Performer is { IsLive: true, HasPose: true };
            if (Performer is { HasPose: true } performer)
                Retarget(performer, _rig!);

            Blend(isLive);
            if (_hasPose)
            {
                Stand(_rig!);
                Write(_rig!, Mathf.Clamp01(_weight) * _presence);
            }

            IsDriving = isLive && _hasPose;
            Problem = Explain();
        }

        private bool TryBind()
        {
            if (_rig != null && IsBound)
                return true;
            if (_rig != null)
                Rebind();
            // In edit mode, time need not pass.
            if (_rigProblem != null && Application.isPlaying && Time.unscaledTime < _rebindTime)
                return false;

            _rebindTime = Time.unscaledTime + RebindPeriod;
            _rig = CreateRig(out string problem);
            _rigProblem = _rig is null ? problem : null;
            _retargeted = null;
            _hasPose = false;
            ForgetController();
            return _rig != null;
        }

        private Performer? FindPerformer()
        {
            ActiveSource = FindSource();
            if (ActiveSource == null)
                return null;
            if (AssignedSender is { } sender)
                return ActiveSource.FindPerformer(_performerIndex, sender);

            Performer? found;
            return _performerChoice == PerformerChoice.ByName
                ? ActiveSource.TryGetPerformer(_performerName, out found) ? found : null
                : ActiveSource.TryGetPerformer(_performerIndex, out found) ? found : null;
        }

        private MocapSource? FindSource()
        {
            if (_source != null)
                return _source;

            // Keeps a source that was found, because the first source of the scene may change.
            if (ActiveSource != null && ActiveSource.isActiveAndEnabled)
                return ActiveSource;

            for (Transform? above = transform; above != null; above = above.parent)
            {
                if (above.TryGetComponent(out MocapSource own) && own.isActiveAndEnabled)
                    return own;
            }

            return MocapSource.All.Count > 0 ? MocapSource.All[0] : null;
        }

        private void Retarget(Performer performer, FigureRig rig)
        {
            if (_retargeted != performer || _body != performer.BodyVersion)
                rig.SetBody(performer.Body);

            // A new performer, another place of its stage, or the end of another pose is no movement.
            if (_retargeted != performer || _placement != performer.PlacementVersion)
            {
                rig.ForgetFeet();
                _motionSmoothing?.Reset();
                _travel.Reset();
            }

            (_retargeted, _body, _placement) = (performer, performer.BodyVersion, performer.PlacementVersion);
            SetOptions(rig);
            if (!rig.TryRetarget(PlaceOnStage(performer, PoseOf(performer), rig)))
                return;

            _hasPose = true;
            PlantFeet(performer, rig);
            MoveRoot(rig);
        }

        private void SetOptions(FigureRig rig)
        {
            RetargetOptions options = rig.Options;
            options.RootMotion = _rootMotion;
            options.HeightOffset = float.IsFinite(_heightOffset) ? _heightOffset : 0;
            options.Scale = _automaticScale || !(_scale >= 0 && float.IsFinite(_scale)) ? (float?)null : _scale;
            options.Displacement = _displacement;
            options.Weights.Reset();
            _partWeights.CopyTo(options.Weights);
            CopyBoneWeights(options.Weights);
        }

        // With in-place root motion, feet slide by design.
        private void PlantFeet(Performer performer, FigureRig rig)
        {
            if (!_footPlanting || _rootMotion == RootMotion.InPlace)
            {
                rig.ForgetFeet();
                return;
            }

            FootPlanterOptions options = rig.FootOptions;
            options.GroundHeight = float.IsFinite(_groundHeight) ? _groundHeight : 0;
            options.BlendIn = options.BlendOut = TimeSpan.FromSeconds(_footBlendTime >= 0 ? Math.Min(_footBlendTime, 1) : 0);
            options.FootRotation = _footRotation;
            rig.PlantFeet(performer.Contacts, TimeOf(performer));
        }

        // Updates the weight of the pose while data comes and goes. In edit mode, the time of the game need not pass.
        private void Blend(bool isLive)
        {
            float target = isLive || _whenIdle == IdleBehaviour.Hold ? 1 : 0;
            _presence = _idleBlendTime > 0 && !_isPreviewed ? Mathf.MoveTowards(_presence, target, FrameTime.Delta / _idleBlendTime) : target;
        }

        private void Stand(FigureRig rig)
        {
            if (_idle?.Rig != rig.Target)
                _idle = IsStanding ? new IdleBlend(rig.Target) : null;

            _idle?.Apply(rig.Pose, IsStanding, _idleBlendTime > 0 ? FrameTime.Delta / _idleBlendTime : 1);
        }

        private void RestoreRest()
        {
            _rig?.Writer.Restore();
            _rig?.Bodies.Restore();
            _hasPose = false;
        }
    }
}
