package org.selectiverenderer.browser.sai;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.ProfileInfo;

/**
 * The profiles, components and optional features that the browser supports (X3D 4.0, 4.6);
 * components and levels are those of the node catalogue.
 */
final class BrowserCapabilities {
  private static final List<String> PROFILES =
      List.of(
          "Core",
          "Interchange",
          "Interactive",
          "MPEG4Interactive",
          "MedicalInterchange",
          "CADInterchange",
          "Immersive",
          "Full");

  private final Map<String, Integer> levels = new TreeMap<>();

  BrowserCapabilities(NodeCatalogue catalogue) {
    for (NodeType type : catalogue.all()) {
      levels.merge(type.component(), type.level(), Math::max);
    }
  }

  ProfileInfo[] profiles() {
    return PROFILES.stream().map(this::profile).toArray(ProfileInfo[]::new);
  }

  boolean knows(String profile) {
    return PROFILES.contains(profile);
  }

  ProfileInfo profile(String name) {
    if (!knows(name)) {
      throw new NotSupportedException("there is no profile " + name);
    }
    return new Profile(name, components());
  }

  ComponentInfo[] components() {
    return components(levels);
  }

  static ComponentInfo[] components(Map<String, Integer> levels) {
    return levels.entrySet().stream()
        .sorted(Comparator.comparing(Map.Entry::getKey))
        .map(entry -> new Component(entry.getKey(), entry.getValue()))
        .toArray(ComponentInfo[]::new);
  }

  ComponentInfo component(String name, int level) {
    int highest = levels.getOrDefault(name, 0);
    if (level < 1 || level > highest) {
      throw new NotSupportedException(
          "component %s is supported up to level %s".formatted(name, highest));
    }
    return new Component(name, level);
  }

  /**
   * Returns the browser properties: which optional parts of the SAI are supported (ISO/IEC 19775-2,
   * 6.2.4).
   */
  static Map<String, Object> browserProperties() {
    return Map.of(
        "ABSTRACT_NODES", true,
        "CONCRETE_NODES", true,
        "EXTERNAL_INTERACTIONS", true,
        "PROTOTYPE_CREATE", false,
        "DOM_IMPORT", true,
        "XML_ENCODING", true,
        "CLASSIC_VRML_ENCODING", true,
        "BINARY_ENCODING", false);
  }

  private record Component(String name, int level) implements ComponentInfo {
    @Override
    public String getName() {
      return name;
    }

    @Override
    public int getLevel() {
      return level;
    }

    @Override
    public String getTitle() {
      return name;
    }

    @Override
    public String getProviderURL() {
      return "";
    }

    @Override
    public String toX3DString() {
      return "<component name=\"%s\" level=\"%s\"/>".formatted(name, level);
    }
  }

  private record Profile(String name, ComponentInfo[] components) implements ProfileInfo {
    @Override
    public String getName() {
      return name;
    }

    @Override
    public String getTitle() {
      return name;
    }

    @Override
    public ComponentInfo[] getComponents() {
      return components.clone();
    }

    @Override
    public String toX3DString() {
      return "profile=\"" + name + "\"";
    }
  }
}
