#nullable enable
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // The positions of a point during the last seconds, in a ring of fixed memory.
    internal sealed class PositionTrail
    {
        private readonly Vector3[] _points;
        private readonly float[] _times;
        private int _first;

        public PositionTrail(int capacity)
        {
            _points = new Vector3[capacity];
            _times = new float[capacity];
        }

        public int Count { get; private set; }

        // Index 0 is the oldest position.
        public Vector3 this[int index] => _points[(_first + index) % _points.Length];

        public void Add(Vector3 point, float time, float length)
        {
            while (Count > 0 && (_times[_first] < time - length || Count == _points.Length))
            {
                _first = (_first + 1) % _points.Length;
                Count--;
            }

            int next = (_first + Count) % _points.Length;
            _points[next] = point;
            _times[next] = time;
            Count++;
        }

        public void Clear() => Count = 0;

        public void Draw(Color color)
        {
            for (int i = 1; i < Count; i++)
            {
                // The trail fades towards its end.
                Gizmos.color = new Color(color.r, color.g, color.b, color.a * i / Count);
                Gizmos.DrawLine(this[i - 1], this[i]);
            }
        }
    }
}
