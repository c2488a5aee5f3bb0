package org.selectiverenderer.polygon;

/** What schemas choose a version or a level of. */
sealed interface ChoiceKey permits CountGraphNode, CountedTexture {}
