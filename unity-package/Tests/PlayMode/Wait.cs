#nullable enable
using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;

namespace NeuronMocap.Unity.Tests
{
    internal static class Wait
    {
        // Far longer than any usual wait, so that only a failure reaches it.
        private const float Unexpected = 30;

        public static IEnumerator Until(Func<bool> condition, string what)
        {
            float end = Time.realtimeSinceStartup + Unexpected;
            while (!condition())
            {
                if (Time.realtimeSinceStartup > end)
                    Assert.Fail($"The wait timed out: {what}.");

                yield return null;
            }
        }
    }
}
