package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.schema.MetadataNode;
import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.core.MetadataDouble;
import org.web3d.x3d.sai.core.MetadataFloat;
import org.web3d.x3d.sai.core.MetadataInteger;
import org.web3d.x3d.sai.core.MetadataSet;
import org.web3d.x3d.sai.core.MetadataString;

/**
 * A metadata node of a running scene, whose fields are read through the SAI when they are first
 * asked for, and once: readers of schemas go through metadata several times.
 */
final class SaiMetadata implements MetadataNode {
  private final X3DNode node;
  private final int hash;
  private @Nullable String name;
  private @Nullable List<String> values;
  private @Nullable List<SaiMetadata> children;

  /**
   * @param node the metadata node, which is an {@link X3DMetadataObject} too
   */
  private SaiMetadata(X3DNode node) {
    this.node = node;
    hash = node.hashCode();
  }

  X3DNode node() {
    return node;
  }

  /** Two are equal when their nodes are. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other == this
        || (other instanceof SaiMetadata metadata
            && hash == metadata.hash
            && node.equals(metadata.node));
  }

  @Override
  public int hashCode() {
    return hash;
  }

  /** Returns the metadata of a node, if it has any. */
  static Optional<SaiMetadata> of(X3DNode owner) {
    return owner.getMetadata() instanceof X3DNode node
        ? Optional.of(new SaiMetadata(node))
        : Optional.empty();
  }

  @Override
  public boolean isSet() {
    return node instanceof MetadataSet;
  }

  @Override
  public String name() {
    String known = name;
    if (known == null) {
      String read = ((X3DMetadataObject) node).getName();
      known = read == null ? "" : read; // Xj3D, where the file has none
      name = known;
    }
    return known;
  }

  @Override
  public List<String> values() {
    List<String> known = values;
    if (known == null) {
      known = readValues();
      values = known;
    }
    return known;
  }

  private List<String> readValues() {
    if (node instanceof MetadataString strings) {
      String[] values = new String[strings.getNumValue()];
      strings.getValue(values);
      return List.of(values);
    }
    if (node instanceof MetadataFloat floats) {
      float[] values = new float[floats.getNumValue()];
      floats.getValue(values);
      List<String> text = new ArrayList<>();
      for (float value : values) {
        text.add(Float.toString(value));
      }
      return text;
    }
    if (node instanceof MetadataDouble doubles) {
      double[] values = new double[doubles.getNumValue()];
      doubles.getValue(values);
      return Arrays.stream(values).mapToObj(Double::toString).toList();
    }
    if (node instanceof MetadataInteger integers) {
      int[] values = new int[integers.getNumValue()];
      integers.getValue(values);
      return Arrays.stream(values).mapToObj(Integer::toString).toList();
    }
    return List.of();
  }

  @Override
  public Optional<SaiMetadata> metadata() {
    return of(node);
  }

  @Override
  public List<SaiMetadata> children() {
    List<SaiMetadata> known = children;
    if (known == null) {
      known = readChildren();
      children = known;
    }
    return known;
  }

  private List<SaiMetadata> readChildren() {
    if (!(node instanceof MetadataSet set)) {
      return List.of();
    }
    X3DNode[] nodes = new X3DNode[set.getNumValue()];
    set.getValue(nodes);
    List<SaiMetadata> found = new ArrayList<>(nodes.length);
    for (X3DNode child : nodes) {
      if (child instanceof X3DMetadataObject) {
        found.add(new SaiMetadata(child));
      }
    }
    return found;
  }
}
