#nullable enable
using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>What a built figure looks like. Takes effect when the figure is built.</summary>
    [Serializable]
    public sealed class FigureLook
    {
        [SerializeField]
        [Tooltip("Colour of body, limbs and head.")]
        private Color _bodyColor = new Color(0.78f, 0.8f, 0.84f);

        [SerializeField]
        [Tooltip("Colour of joints and visor.")]
        private Color _accentColor = new Color(0.95f, 0.42f, 0.1f);

        [SerializeField]
        [Tooltip("A material to copy and colour. Empty: the render pipeline's own lit material. Set one for builds whose shaders are stripped: "
            + "a shader that no material of the project uses is not in the player.")]
        private Material? _material;

        /// <summary>Colour of body, limbs and head.</summary>
        public Color BodyColor
        {
            get => _bodyColor;
            set => _bodyColor = value;
        }

        /// <summary>Colour of joints and visor.</summary>
        public Color AccentColor
        {
            get => _accentColor;
            set => _accentColor = value;
        }

        /// <summary>
        /// A material to copy and colour; null for the render pipeline's own lit material. A player contains only shaders that some material of the project
        /// uses, so a build may need one here.
        /// </summary>
        public Material? Material
        {
            get => _material;
            set => _material = value;
        }

        /// <summary>A look of the given colours.</summary>
        /// <param name="body">Colour of body, limbs and head.</param>
        /// <param name="accent">Colour of joints and visor.</param>
        /// <returns>A new look.</returns>
        public static FigureLook Of(Color body, Color accent) => new FigureLook { _bodyColor = body, _accentColor = accent };

        /// <summary>A look whose joints have a colour of their own for each number, far from that of its neighbours.</summary>
        /// <param name="number">Any number, such as that of an avatar.</param>
        /// <returns>A new look.</returns>
        public static FigureLook Numbered(int number)
        {
            // Steps of the golden ratio never come close to each other soon.
            float hue = Mathf.Repeat(0.06f + (number * 0.618034f), 1);
            return Of(new Color(0.78f, 0.8f, 0.84f), Color.HSVToRGB(hue, 0.8f, 0.95f));
        }
    }
}
