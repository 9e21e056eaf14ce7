#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>A figure that a <see cref="PerformerSpawner"/> made.</summary>
    public sealed class SpawnedFigure
    {
        private IdleBlend? _blend;
        private IdlePose _idlePose;

        internal SpawnedFigure(GameObject root, FigureDriver driver, Performer performer, int place)
        {
            Root = root;
            Driver = driver;
            Performer = performer;
            Place = place;
            if (root.TryGetComponent(out FigureBuilder builder))
            {
                builder.Built += figure => Capture(figure.Animator);
                Capture(builder.Figure?.Animator);
            }
            else if (driver is HumanoidDriver humanoid)
            {
                Capture(humanoid.Animator);
            }
        }

        /// <summary>The figure's object, a child of the spawner.</summary>
        public GameObject Root { get; }

        /// <summary>Moves the figure.</summary>
        public FigureDriver Driver { get; }

        /// <summary>Whose figure it is. After a long pause, another object for the same one.</summary>
        public Performer Performer { get; internal set; }

        /// <summary>Which of the spawner's places it stands at, from 0.</summary>
        public int Place { get; }

        /// <summary>Whether the performer's data has stopped.</summary>
        public bool IsIdle { get; private set; }

        /// <summary>For how long it has been idle; seconds.</summary>
        public float IdleSeconds { get; private set; }

        internal bool IsDestroyed => Root == null;

        // True when it became idle, or ceased to be.
        internal bool Update(bool isLive, IdlePose pose, float blendSeconds, float deltaTime)
        {
            IdleSeconds = isLive ? 0 : IdleSeconds + deltaTime;
            if (isLive != IsIdle)
                return false;

            IsIdle = !isLive;
            if (isLive)
                Return();
            else
                Leave(pose, blendSeconds);

            return true;
        }

        internal void Apply(float step) => _blend?.Apply(step);

        private void Leave(IdlePose pose, float blendSeconds)
        {
            _idlePose = pose;
            Driver.WhenIdle = pose == IdlePose.Rest ? IdleBehaviour.BlendToRest : IdleBehaviour.Hold;
            Driver.IdleBlendTime = blendSeconds;
            if (pose == IdlePose.Stand)
                _blend?.Leave();
            else if (pose == IdlePose.Hide)
                Root.SetActive(false);
        }

        private void Return()
        {
            if (_idlePose == IdlePose.Stand)
                _blend?.Return();
            else if (_idlePose == IdlePose.Hide)
                Root.SetActive(true);
        }

        // Before the driver has moved it.
        private void Capture(Animator? animator)
        {
            if (animator != null && animator.isHuman)
                _blend = new IdleBlend(animator);
        }
    }
}
