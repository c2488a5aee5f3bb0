package org.selectiverenderer.runtime.instance;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.RandomAccess;
import org.joml.Matrix4dc;

/** The instances of a node, which is also a list of their world matrices. */
final class NodeInstances extends AbstractList<Matrix4dc> implements RandomAccess {
  private final List<Instance> instances = new ArrayList<>(1);
  private final List<Instance> view = Collections.unmodifiableList(instances);

  void append(Instance instance) {
    instances.add(instance);
  }

  List<Instance> instances() {
    return view;
  }

  @Override
  public Matrix4dc get(int index) {
    return instances.get(index).world();
  }

  @Override
  public int size() {
    return instances.size();
  }
}
