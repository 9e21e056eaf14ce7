#nullable enable
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace NeuronMocap.Unity.Tests
{
    /// <summary>The path from the built-in simulator to a moving figure, and its behaviour when objects come and go.</summary>
    public sealed class SimulatedPerformerTests
    {
        private GameObject _root = null!;
        private MocapSource _source = null!;
        private FigureBuilder _figure = null!;

        /// <summary>A source with one simulated performer, and a figure for it.</summary>
        [SetUp]
        public void Create()
        {
            _root = new GameObject("Test");
            _root.SetActive(false);
            _source = CreateChild("Source").AddComponent<MocapSource>();
            _source.Kind = SourceKind.Simulator;
            _figure = CreateChild("Figure").AddComponent<FigureBuilder>();
            _figure.GetComponent<HumanoidDriver>().Source = _source;
            _root.SetActive(true);
        }

        /// <summary>Removes both.</summary>
        [TearDown]
        public void Remove() => Object.DestroyImmediate(_root);

        /// <summary>The hand of the figure moves.</summary>
        /// <returns>The steps of the test.</returns>
        [UnityTest]
        public IEnumerator A_simulated_performer_moves_a_figure()
        {
            yield return Wait.Until(() => _figure.Driver.IsDriving, "a driven figure");
            Vector3 start = GetHandPosition();

            yield return Wait.Until(() => (GetHandPosition() - start).magnitude > 0.05f, "a hand that moves");
            Assert.That(_source.Performers.Count, Is.EqualTo(1));
            Assert.That(_figure.Driver.Problem, Is.Empty);
        }

        /// <summary>A disabled source removes its performers. Enabled again, it finds them again.</summary>
        /// <returns>The steps of the test.</returns>
        [UnityTest]
        public IEnumerator A_source_can_be_disabled_and_enabled()
        {
            int joined = 0;
            int left = 0;
            _source.PerformerJoined += _ => joined++;
            _source.PerformerLeft += _ => left++;
            for (int round = 1; round <= 2; round++)
            {
                yield return Wait.Until(() => _source.Performers.Count == 1, "a performer");
                _source.enabled = false;

                Assert.That(_source.IsOpen, Is.False);
                Assert.That(_source.Performers.Count, Is.Zero);
                Assert.That(joined, Is.EqualTo(round));
                Assert.That(left, Is.EqualTo(round));
                _source.enabled = true;
            }
        }

        /// <summary>The figure is destroyed with its builder and returns with it.</summary>
        /// <returns>The steps of the test.</returns>
        [UnityTest]
        public IEnumerator A_figure_ends_with_its_builder()
        {
            yield return Wait.Until(() => _figure.Driver.IsDriving, "a driven figure");
            GameObject built = _figure.Figure!.Root;

            _figure.enabled = false;
            yield return null;
            Assert.That(built == null, Is.True);

            _figure.enabled = true;
            yield return Wait.Until(() => _figure.Driver.IsDriving, "a driven figure again");
        }

        // Looked up each time, because the figure is rebuilt when the performer's sizes are known.
        private Vector3 GetHandPosition() => _figure.Figure!.Animator.GetBoneTransform(HumanBodyBones.LeftHand)!.position;

        private GameObject CreateChild(string name)
        {
            var child = new GameObject(name);
            child.transform.SetParent(_root.transform, false);
            return child;
        }
    }
}
