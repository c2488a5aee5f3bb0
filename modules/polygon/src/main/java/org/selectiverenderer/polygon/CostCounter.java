package org.selectiverenderer.polygon;

import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Counts draw calls and bytes of textures for one choice of versions and levels. */
final class CostCounter {
  private final Map<? extends ChoiceKey, Integer> choices;
  private final Map<ParsedNode, CountedTexture> varying = new IdentityHashMap<>();
  private final Map<CountGraphNode, Long> drawn = new IdentityHashMap<>();

  /**
   * @param choices the shown version of each versioned object, and level of each texture
   * @param textures the textures whose pictures vary
   */
  CostCounter(Map<? extends ChoiceKey, Integer> choices, List<CountedTexture> textures) {
    this.choices = choices;
    textures.forEach(texture -> varying.putIfAbsent(texture.texture(), texture));
  }

  RenderingCost of(CountGraphNode item) {
    Set<TextureUse> uses = new HashSet<>();
    collect(item, uses, new HashSet<>());
    Map<Object, Long> pictures = new HashMap<>();
    for (TextureUse use : uses) {
      Optional<TexturePicture> picture = use.picture(urls(use.texture()));
      picture.ifPresent(found -> pictures.put(found.key(), found.bytes()));
    }
    long bytes = pictures.values().stream().mapToLong(Long::longValue).sum();
    return new RenderingCost(draws(item), bytes);
  }

  private List<String> urls(ParsedNode texture) {
    CountedTexture counted = varying.get(texture);
    if (counted != null) {
      Integer level = choices.get(counted);
      return counted.urls(level == null ? -1 : level);
    }
    return texture.type().field("url").isPresent() ? List.of(texture.strings("url")) : List.of();
  }

  private List<CountGraphNode> shown(CountGraphNode item) {
    Integer choice = choices.get(item);
    return item.shown(choice == null ? item.whichChoice() : choice);
  }

  private long draws(CountGraphNode item) {
    if (!item.varies) {
      return item.drawCalls;
    }
    Long known = drawn.get(item);
    if (known == null) {
      known = 0L;
      for (CountGraphNode child : shown(item)) {
        known = CountGraphNode.plus(known, draws(child));
      }
      drawn.put(item, known);
    }
    return known;
  }

  private void collect(CountGraphNode item, Set<TextureUse> uses, Set<CountGraphNode> seen) {
    if (!item.varies) {
      uses.addAll(item.textures());
    } else if (seen.add(item)) {
      shown(item).forEach(child -> collect(child, uses, seen));
    }
  }
}
