#nullable enable
using System;
using System.Collections.Generic;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Reads a character's pose as the values of a clip.
    internal abstract class ClipSampler : IDisposable
    {
        private readonly List<Quaternion> _last = new List<Quaternion>();
        private int _next;
        private int _rotation;

        protected ClipSampler(IReadOnlyList<ClipProperty> properties)
        {
            Properties = properties;
            int count = 0;
            foreach (ClipProperty property in properties)
            {
                count += property.Components.Count;
                if (property.IsRotation)
                    _last.Add(Quaternion.identity);
            }

            Values = new float[count];
        }

        public IReadOnlyList<ClipProperty> Properties { get; }

        // The values of the newest sample. The array is reused.
        public float[] Values { get; }

        // Whether the character was destroyed.
        public abstract bool IsGone { get; }

        protected abstract TakeOrigin Origin { get; }

        public void Sample()
        {
            _next = 0;
            _rotation = 0;
            Read();
        }

        // Goes on with the take of a character that this one replaces. Returns false if the values have other meanings.
        public bool TryContinue(ClipSampler before)
        {
            if (Properties.Count != before.Properties.Count)
                return false;

            for (int i = 0; i < Properties.Count; i++)
            {
                if (!Properties[i].IsSame(before.Properties[i]))
                    return false;
            }

            Origin.Continue(before.Origin);
            for (int i = 0; i < _last.Count; i++)
                _last[i] = before._last[i];

            return true;
        }

        public virtual void Dispose()
        {
        }

        protected abstract void Read();

        protected void Put(float value) => Values[_next++] = value;

        protected void Put(Vector3 value)
        {
            Put(value.x);
            Put(value.y);
            Put(value.z);
        }

        // A rotation that is no longer known keeps its last value.
        protected void Keep() => Put(_last[_rotation]);

        // Two quaternions describe each rotation. This writes the one closer to the last, because curves interpolate between values.
        protected void Put(Quaternion value)
        {
            if (Quaternion.Dot(value, _last[_rotation]) < 0)
                value = new Quaternion(-value.x, -value.y, -value.z, -value.w);

            _last[_rotation++] = value;
            Put(value.x);
            Put(value.y);
            Put(value.z);
            Put(value.w);
        }
    }
}
