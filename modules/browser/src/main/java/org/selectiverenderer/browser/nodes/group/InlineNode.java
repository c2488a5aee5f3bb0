package org.selectiverenderer.browser.nodes.group;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Inline: holds the scene of another file (X3D 4.0, 9.4.2). */
public final class InlineNode extends GroupingNode {
  private final int load;
  private final int url;
  private @Nullable Scene content;
  private double scale = 1;
  private String @Nullable [] asked;

  public InlineNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    load = type.indexOf("load");
    url = type.indexOf("url");
  }

  /** Returns the loaded scene; empty before it is loaded and if it could not be read. */
  public Optional<Scene> content() {
    return Optional.ofNullable(content);
  }

  /** Returns the scene shown: the loaded one, unless {@code load} is FALSE. */
  public Optional<Scene> shown() {
    return (Boolean) value(load) ? content() : Optional.empty();
  }

  /**
   * Sets the content.
   *
   * @param newScale the units of length of the including scene per unit of the content (X3D 4.0,
   *     4.3.6)
   */
  public void fill(@Nullable Scene newContent, double newScale) {
    content = newContent;
    scale = newScale;
  }

  /**
   * Returns the value of the field {@code url} for which the content was requested; null if none
   * was requested.
   */
  public String @Nullable [] asked() {
    return asked;
  }

  /** Notes the urls for which the content was requested, whether or not they could be read. */
  public void asked(String[] urls) {
    asked = urls;
  }

  /**
   * Replaces the content while the world runs: observers are told of other children, but no event
   * is sent.
   */
  public void refill(@Nullable Scene newContent, double newScale) {
    fill(newContent, newScale);
    tellObservers(load);
  }

  @Override
  public List<Node> children() {
    return shown().map(scene -> List.of(scene.root())).orElse(List.of());
  }

  @Override
  public Optional<Matrix4d> placement() {
    return scale == 1 ? Optional.empty() : Optional.of(new Matrix4d().scale(scale));
  }

  /** Returns the index of the field {@code url}. */
  public int urlField() {
    return url;
  }

  @Override
  public Effect effectOf(int field) {
    return field == load ? Effect.STRUCTURE : super.effectOf(field);
  }
}
