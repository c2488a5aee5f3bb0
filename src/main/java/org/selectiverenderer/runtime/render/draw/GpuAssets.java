package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.gpu.ShapeVariant;
import org.selectiverenderer.runtime.render.light.LightPlanner;
import org.selectiverenderer.runtime.render.light.Lighting;
import org.selectiverenderer.runtime.render.light.MeshForm;
import org.selectiverenderer.runtime.render.light.MeshSurvey;
import org.selectiverenderer.runtime.render.mesh.MeshPacker;
import org.selectiverenderer.runtime.render.mesh.PackedMesh;

/** What is on the graphics card, once per mesh and image however many shapes use it. */
final class GpuAssets {
  private static final float[] NO_TRANSFORM = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final LightPlanner planner;
  private final Map<MeshForm, Made> meshes = new HashMap<>();
  private final Map<Texture, GpuTexture> textures = new HashMap<>();
  private final ShapePrograms programs = new ShapePrograms();
  private final Map<DrawList.State, Integer> ranks = new HashMap<>();
  private final Map<List<LightInstance>, List<LightInstance>> lists = new HashMap<>();
  private long uploads;

  /**
   * @param survey of what is drawn, where that matters to its light
   */
  private record Made(GpuMesh mesh, MeshSurvey survey) {}

  private record Packed(MeshForm form, PackedMesh mesh, MeshSurvey survey) {}

  /** A shape's mesh, and how it is lit. */
  record Lit(LightPlanner.Request request, GpuMesh mesh, Lighting lighting) {}

  GpuAssets(LightPlanner planner) {
    this.planner = planner;
  }

  /** Meshes and textures sent to the graphics card since the start. */
  long uploads() {
    return uploads;
  }

  /**
   * Decides how shapes are lit and uploads their meshes; those that are new are looked at, refined
   * and packed on all processors.
   *
   * @return one for each request, in their order
   */
  List<Lit> prepare(GL3 gl, List<LightPlanner.Request> requests) {
    Map<Mesh, MeshSurvey> surveys = surveys(requests);
    List<LightPlanner.Plan> plans =
        requests.parallelStream()
            .map(request -> planner.plan(request, surveys.get(request.mesh())))
            .toList();
    Map<MeshForm, LightPlanner.Plan> missing = new LinkedHashMap<>();
    for (LightPlanner.Plan plan : plans) {
      if (!meshes.containsKey(plan.form())) {
        missing.putIfAbsent(plan.form(), plan);
      }
    }
    missing.values().parallelStream()
        .map(plan -> pack(plan, surveys))
        .toList()
        .forEach(packed -> upload(gl, packed));
    List<Lit> lit = new ArrayList<>(plans.size());
    for (LightPlanner.Plan plan : plans) {
      Made made = meshes.get(plan.form());
      List<LightInstance> reaching = lists.computeIfAbsent(plan.reaching(), list -> list);
      lit.add(new Lit(plan.request(), made.mesh(), plan.lighting(made.survey(), reaching)));
    }
    return lit;
  }

  private Map<Mesh, MeshSurvey> surveys(List<LightPlanner.Request> requests) {
    Set<Mesh> distinct = Collections.newSetFromMap(new IdentityHashMap<>());
    requests.forEach(request -> distinct.add(request.mesh()));
    Map<Mesh, MeshSurvey> surveys = new IdentityHashMap<>();
    distinct.parallelStream()
        .map(mesh -> Map.entry(mesh, planner.survey(mesh)))
        .toList()
        .forEach(surveyed -> surveys.put(surveyed.getKey(), surveyed.getValue()));
    return surveys;
  }

  private Packed pack(LightPlanner.Plan plan, Map<Mesh, MeshSurvey> surveys) {
    Mesh source = plan.form().source();
    Mesh mesh = plan.refined() == null ? LightPlanner.mesh(plan.form()) : plan.refined();
    MeshSurvey survey = mesh == source ? surveys.get(source) : planner.survey(mesh);
    return new Packed(plan.form(), MeshPacker.pack(mesh), survey);
  }

  private void upload(GL3 gl, Packed packed) {
    meshes.put(packed.form(), new Made(new GpuMesh(gl, packed.mesh()), packed.survey()));
    uploads++;
  }

  DrawItem item(GL3 gl, Lit lit) {
    ShapeInstance shape = lit.request().shape();
    Mesh mesh = lit.request().mesh();
    Surface surface = shape.surface();
    GpuTexture texture =
        surface.texture() == null || mesh.texCoords() == null
            ? null
            : textures.computeIfAbsent(
                surface.texture(),
                image -> {
                  uploads++;
                  return new GpuTexture(gl, image);
                });
    boolean blended = blended(surface, lit.mesh(), texture);
    ShapeVariant variant = variant(mesh, surface, texture, blended);
    ShapePrograms.Family byPixel = programs.get(variant);
    float[] transform = surface.textureTransform();
    return new DrawItem(
        shape,
        mesh,
        surface,
        lit.mesh(),
        texture,
        byPixel,
        programs.get(variant.lit(true)),
        lit.lighting(),
        numbers(surface),
        transform == null ? NO_TRANSFORM : transform,
        blended,
        ranks.computeIfAbsent(new DrawList.State(byPixel, texture), state -> ranks.size()));
  }

  private static boolean blended(Surface surface, GpuMesh mesh, @Nullable GpuTexture texture) {
    return surface.transparency() > 0
        || mesh.translucentColors()
        || (texture != null && texture.alpha() == GpuTexture.Alpha.BLENDED);
  }

  private static ShapeVariant variant(
      Mesh mesh, Surface surface, @Nullable GpuTexture texture, boolean blended) {
    boolean shiny =
        surface.specular()[0] > 0 || surface.specular()[1] > 0 || surface.specular()[2] > 0;
    Texture image = surface.texture();
    return new ShapeVariant(
        surface.lit() && mesh.normals() != null,
        shiny,
        false,
        mesh.colors() != null,
        texture != null,
        image != null && image.image().components() <= 2,
        texture != null && texture.alpha() == GpuTexture.Alpha.CUT_OUT,
        !mesh.solid(),
        mesh.primitive() == Mesh.Primitive.POINTS,
        blended);
  }

  private static float[] numbers(Surface surface) {
    float[] d = surface.diffuse();
    float[] e = surface.emissive();
    float[] s = surface.specular();
    return new float[] {
      d[0],
      d[1],
      d[2],
      1 - surface.transparency(),
      e[0],
      e[1],
      e[2],
      surface.ambientIntensity(),
      s[0],
      s[1],
      s[2],
      surface.shininess() * 128
    };
  }

  /** Frees what none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    Set<GpuMesh> usedMeshes = new HashSet<>();
    Set<GpuTexture> usedTextures = new HashSet<>();
    Set<List<LightInstance>> usedLists = new HashSet<>();
    for (DrawItem item : items) {
      usedMeshes.add(item.mesh());
      usedTextures.add(item.texture());
      usedLists.add(item.lighting().reaching());
    }
    lists.keySet().retainAll(usedLists);
    meshes
        .values()
        .removeIf(
            made -> {
              boolean unused = !usedMeshes.contains(made.mesh());
              if (unused) {
                made.mesh().dispose(gl);
              }
              return unused;
            });
    textures
        .values()
        .removeIf(
            texture -> {
              boolean unused = !usedTextures.contains(texture);
              if (unused) {
                texture.dispose(gl);
              }
              return unused;
            });
    ranks.keySet().removeIf(s -> s.texture() != null && !usedTextures.contains(s.texture()));
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    programs.dispose(gl);
  }
}
