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
 * A metadata node of a running scene, read through the SAI.
 *
 * @param node the metadata node, which is an {@link X3DMetadataObject} too
 */
record SaiMetadata(X3DNode node) implements MetadataNode {
  /**
   * Two are equal when their nodes are. Written out, because Java generates a record's methods at
   * first use, which takes time.
   */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof SaiMetadata metadata && node.equals(metadata.node);
  }

  @Override
  public int hashCode() {
    return node.hashCode();
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
    String name = ((X3DMetadataObject) node).getName();
    return name == null ? "" : name; // Xj3D, where the file has none
  }

  @Override
  public List<String> values() {
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
    if (!(node instanceof MetadataSet set)) {
      return List.of();
    }
    X3DNode[] nodes = new X3DNode[set.getNumValue()];
    set.getValue(nodes);
    List<SaiMetadata> children = new ArrayList<>(nodes.length);
    for (X3DNode child : nodes) {
      if (child instanceof X3DMetadataObject) {
        children.add(new SaiMetadata(child));
      }
    }
    return children;
  }
}
