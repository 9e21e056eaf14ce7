#nullable enable
using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>The look of a built figure. It takes effect when the figure is built.</summary>
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
        [Tooltip("A material to copy and colour. Empty: the lit material of the render pipeline, which builds of the scene include. Set one if a prefab or a "
            + "script adds the figure: with URP or HDRP, a player may lack it otherwise.")]
        private Material? _material;

        /// <summary>Gets or sets the colour of body, limbs and head.</summary>
        public Color BodyColor
        {
            get => _bodyColor;
            set => _bodyColor = value;
        }

        /// <summary>Gets or sets the colour of joints and visor.</summary>
        public Color AccentColor
        {
            get => _accentColor;
            set => _accentColor = value;
        }

        /// <summary>
        /// Gets or sets a material to copy and colour. Null: the lit material of the render pipeline. Builds include it for the components of their
        /// scenes. For figures that prefabs or scripts add, set a material that is in the build.
        /// </summary>
        public Material? Material
        {
            get => _material;
            set => _material = value;
        }

        /// <summary>Creates a look with the given colours.</summary>
        /// <param name="body">Colour of body, limbs and head.</param>
        /// <param name="accent">Colour of joints and visor.</param>
        /// <returns>A new look.</returns>
        public static FigureLook Of(Color body, Color accent) => new FigureLook { _bodyColor = body, _accentColor = accent };

        /// <summary>Creates a look whose joints have a distinct colour for each number, far from the colours of neighbouring numbers.</summary>
        /// <param name="number">Any number, such as that of an avatar.</param>
        /// <returns>A new look.</returns>
        public static FigureLook Numbered(int number)
        {
            // Steps of the golden ratio keep successive hues far apart.
            float hue = Mathf.Repeat(0.06f + (number * 0.618034f), 1);
            return Of(new Color(0.78f, 0.8f, 0.84f), Color.HSVToRGB(hue, 0.8f, 0.95f));
        }
    }
}
