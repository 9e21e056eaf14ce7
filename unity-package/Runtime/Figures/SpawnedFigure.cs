#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>A figure created by a <see cref="PerformerSpawner"/>.</summary>
    public sealed class SpawnedFigure
    {
        private IdlePose _idlePose;

        internal SpawnedFigure(GameObject root, FigureDriver driver, Performer performer, int place)
        {
            Root = root;
            Driver = driver;
            Performer = performer;
            Place = place;
        }

        /// <summary>Gets the figure's object, a child of the spawner.</summary>
        public GameObject Root { get; }

        /// <summary>Gets the driver that moves the figure.</summary>
        public FigureDriver Driver { get; }

        /// <summary>Gets the performer of the figure. After a long pause, the same performer is a new object.</summary>
        public Performer Performer { get; internal set; }

        /// <summary>Gets the figure's place among the spawner's places, from 0.</summary>
        public int Place { get; }

        /// <summary>Gets whether the performer's data has stopped.</summary>
        public bool IsIdle { get; private set; }

        /// <summary>Gets how long the figure has been idle, in seconds.</summary>
        public float IdleSeconds { get; private set; }

        internal bool IsDestroyed => Root == null;

        // Returns true if the figure became idle, or active again.
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

        private void Leave(IdlePose pose, float blendSeconds)
        {
            _idlePose = pose;
            Driver.WhenIdle = pose == IdlePose.Rest ? IdleBehaviour.BlendToRest : IdleBehaviour.Hold;
            Driver.IdleBlendTime = blendSeconds;
            Driver.IsStanding = pose == IdlePose.Stand;
            if (pose == IdlePose.Hide)
                Root.SetActive(false);
        }

        private void Return()
        {
            Driver.IsStanding = false;
            if (_idlePose == IdlePose.Hide)
                Root.SetActive(true);
        }
    }
}
