package org.selectiverenderer.models.structure;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The structure of a glTF file: which of its parts refer to which. Parts refer to each other by the
 * index in their array, in glTF 1.0 by a name; an index is a name here.
 *
 * @param version of glTF, such as 2.0; empty before it is known
 * @param arraysOfMeshes the accessors of each mesh
 * @param children the children of each node
 * @param meshesOfNodes the meshes that each node shows
 * @param scenes the roots of each scene
 * @param otherArrays the accessors of animations and skins
 */
record GltfStructure(
    String version,
    Map<String, Part> accessors,
    Map<String, Part> views,
    Map<String, Part> buffers,
    Map<String, List<String>> arraysOfMeshes,
    Map<String, List<String>> children,
    Map<String, List<String>> meshesOfNodes,
    List<List<String>> scenes,
    List<String> otherArrays) {

  GltfStructure() {
    this(
        "",
        new HashMap<>(),
        new HashMap<>(),
        new HashMap<>(),
        new HashMap<>(),
        new HashMap<>(),
        new HashMap<>(),
        new ArrayList<>(),
        new ArrayList<>());
  }

  /** Returns this structure with the version of glTF, and the same parts. */
  GltfStructure of(String known) {
    return new GltfStructure(
        known,
        accessors,
        views,
        buffers,
        arraysOfMeshes,
        children,
        meshesOfNodes,
        scenes,
        otherArrays);
  }

  /** Returns whether it is glTF 2.0 or a later version of 2. */
  boolean isSecond() {
    return version.startsWith("2.");
  }

  /** A part's members that are numbers or references, by name. */
  record Part(Map<String, Long> numbers, Map<String, String> references) {
    Part() {
      this(new HashMap<>(), new HashMap<>());
    }

    long number(String key) {
      return numbers.getOrDefault(key, 0L);
    }

    boolean has(String key) {
      return references.containsKey(key);
    }
  }
}
