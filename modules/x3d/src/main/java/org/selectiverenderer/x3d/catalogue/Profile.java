package org.selectiverenderer.x3d.catalogue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The profiles of X3D and the components of each (X3D 4.0, annexes A to F, H and L). */
public enum Profile {
  /** Statements and metadata, no nodes to show (annex A). */
  Core("Core 1"),
  /** Geometry, materials, textures and animation, for exchange between programs (annex B). */
  Interchange(
      "Core 1, EnvironmentalEffects 1, Geometry3D 2, Grouping 1, Interpolation 2, Lighting 1,"
          + " Navigation 1, Networking 1, Rendering 3, Shape 1, Texturing 2, Time 1"),
  /** Parts and assemblies of CAD models (annex H). */
  CADInterchange(
      "CADGeometry 2, Core 1, Grouping 1, Lighting 1, Navigation 3, Networking 2, Rendering 4,"
          + " Shaders 1, Shape 2, Texturing 2"),
  /** Interchange with sensors, for simple interaction (annex C). */
  Interactive(
      "Core 1, EnvironmentalEffects 1, EnvironmentalSensor 1, EventUtilities 1, Geometry3D 3,"
          + " Grouping 2, Interpolation 2, KeyDeviceSensor 1, Lighting 2, Navigation 1,"
          + " Networking 2, PointingDeviceSensor 1, Rendering 3, Shape 1, Texturing 2, Time 1"),
  /** The small part of Interactive that MPEG-4 uses (annex D). */
  MPEG4Interactive(
      "Core 1, EnvironmentalEffects 1, EnvironmentalSensor 1, Geometry3D 2, Grouping 2,"
          + " Interpolation 2, Lighting 2, Navigation 1, Networking 2, PointingDeviceSensor 1,"
          + " Rendering 1, Shape 1, Texturing 1, Time 1"),
  /** Worlds to walk in, with sound, text, scripts and all that VRML97 had (annex E). */
  Immersive(
      "Core 2, EnvironmentalEffects 2, EnvironmentalSensor 2, EventUtilities 1, Geometry2D 1,"
          + " Geometry3D 4, Grouping 2, Interpolation 2, KeyDeviceSensor 2, Lighting 2,"
          + " Navigation 2, Networking 3, PointingDeviceSensor 1, Rendering 3, Scripting 1,"
          + " Shape 2, Sound 1, Text 1, Texturing 3, Time 1"),
  /** Medical images and volumes (annex L). */
  MedicalInterchange(
      "Core 1, EnvironmentalEffects 1, EventUtilities 1, Geometry2D 2, Geometry3D 2, Grouping 3,"
          + " Interpolation 2, Lighting 1, Navigation 3, Networking 2, Rendering 5, Shape 3,"
          + " Text 1, Texturing 2, Texturing3D 2, Time 1, VolumeRendering 4"),
  /** All components of the standard at their highest levels (annex F). */
  Full("");

  /** Components that define statements or fields, but no nodes. */
  public static final Set<String> COMPONENTS_WITHOUT_NODES =
      Set.of("Core", "Networking", "Annotation");

  private final Map<String, Integer> levels = new HashMap<>();

  Profile(String components) {
    for (String component : components.split(", ")) {
      int space = component.indexOf(' ');
      if (space > 0) {
        levels.put(component.substring(0, space), Integer.parseInt(component.substring(space + 1)));
      }
    }
  }

  /** Returns the profile of that name. */
  public static Optional<Profile> of(String name) {
    return Arrays.stream(values()).filter(profile -> profile.name().equals(name.strip())).findAny();
  }

  /** Returns the names of all profiles. */
  public static List<String> names() {
    return Arrays.stream(values()).map(Profile::name).toList();
  }

  /** Returns the level at which the profile has a component; 0 for none. */
  public int level(String component) {
    return this == Full ? Integer.MAX_VALUE : levels.getOrDefault(component, 0);
  }

  /**
   * Returns the components that a file of this profile must declare for nodes of some types, in
   * order of their names, with the lowest levels that have them.
   */
  public Map<String, Integer> missing(Stream<NodeType> types) {
    Map<String, Integer> missing = new TreeMap<>();
    types
        .filter(type -> level(type.component()) < type.level())
        .forEach(type -> missing.merge(type.component(), type.level(), Math::max));
    return missing;
  }

  /** Returns the name of a component in X3D 4.0. */
  public static String component(String name) {
    return name.equals("H-Anim") ? "HAnim" : name; // X3D 3 used both names.
  }
}
