#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Selects the frames to keep for a group of values, so that straight lines between them reproduce all other frames.
    internal static class KeyReduction
    {
        // Limits the work, which grows with the square of the gap. Also limits the effect of missing keys when the clip is edited.
        private const int LongestGap = 60;

        // tolerance: the largest error of any value. 0 or less keeps all frames.
        public static IReadOnlyList<int> Keep(int frames, int values, Func<int, float> getTime, Func<int, int, float> getValue, float tolerance)
        {
            var kept = new List<int>();
            if (frames == 0)
                return kept;

            kept.Add(0);
            int from = 0;
            while (from < frames - 1)
            {
                int to = from + 1;
                while (tolerance > 0 && to < frames - 1 && to - from < LongestGap && IsStraight(from, to + 1))
                    to++;

                kept.Add(to);
                from = to;
            }

            return kept;

            bool IsStraight(int first, int last)
            {
                float start = getTime(first);
                float length = getTime(last) - start;
                for (int value = 0; value < values; value++)
                {
                    float begin = getValue(first, value);
                    float change = getValue(last, value) - begin;
                    for (int frame = first + 1; frame < last; frame++)
                    {
                        float part = length > 0 ? (getTime(frame) - start) / length : 0;
                        if (Mathf.Abs(begin + (change * part) - getValue(frame, value)) > tolerance)
                            return false;
                    }
                }

                return true;
            }
        }
    }
}
