package org.selectiverenderer.render.lighting;

import java.util.List;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.SurfaceShading;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.mesh.RefinedMesh;

/**
 * Decides for each shape between per-vertex and per-pixel lighting, and refines meshes where
 * needed; a shape whose author has decided is drawn so, on its own mesh. Refinement for a mesh's
 * curvature and highlights is done once for all shapes that use it; refinement for a near point or
 * spot light is done for the one shape in its place. Stateless; safe for use by several threads.
 */
public final class LightingPlanner {
  /**
   * The largest error of per-vertex light: a few levels of 255, because smooth errors are not
   * visible.
   */
  private static final double TOLERANCE = 2.5 / 255;

  /** Meshes with more triangles are not refined: they are fine enough, or too costly to refine. */
  public static final int HEAVY = 20_000;

  private final boolean byVertex;

  /**
   * @param byVertex whether per-vertex lighting is used where the difference is invisible, else
   *     never
   */
  public LightingPlanner(boolean byVertex) {
    this.byVertex = byVertex;
  }

  /**
   * A shape that is to be drawn.
   *
   * @param mesh the shape's own mesh
   * @param scope the lights in whose scope it lies
   * @param steady whether it and its lights are expected to stay where they are
   */
  public record Request(
      ShapeInstance shape, Mesh mesh, List<LightInstance> scope, boolean steady) {}

  /**
   * The decision about a shape's lighting, before its mesh is made.
   *
   * @param form the key of the mesh that is drawn
   * @param refined that mesh if it is made already; otherwise {@link #mesh} makes it
   */
  public record Plan(
      Request request,
      RefinedMeshKey form,
      @Nullable RefinedMesh refined,
      boolean byVertex,
      List<LightInstance> reaching) {

    /**
     * Returns the lighting of the shape after its mesh is made.
     *
     * @param drawn the metrics of the mesh that is drawn
     * @param lights the lights that reach the shape, in one list shared by all shapes with equal
     *     ones
     */
    public ShapeLighting lighting(MeshMetrics drawn, List<LightInstance> lights) {
      ShapeInstance shape = request.shape();
      boolean lit = lit(request);
      ShapeLighting.Unsteady unsteady =
          request.steady() || !lit
              ? null
              : new ShapeLighting.Unsteady(
                  drawn.longest(), tolerance(shape.surface(), request.mesh()));
      return new ShapeLighting(shape, request.scope(), lights, lit, byVertex, unsteady);
    }
  }

  /** Measures a mesh for {@link #plan}; one pass over its triangles. */
  public MeshMetrics survey(Mesh mesh) {
    return byVertex ? MeshMetrics.of(mesh) : MeshMetrics.FINE;
  }

  public Plan plan(Request request, MeshMetrics survey) {
    ShapeInstance shape = request.shape();
    Mesh mesh = request.mesh();
    LightCuller reach = new LightCuller(shape.bounds());
    RefinedMeshKey plain = RefinedMeshKey.plain(mesh);
    if (!shape.programs().isEmpty()) {
      // A custom shader may use any light, whether the material is lit or not.
      return new Plan(request, plain, null, false, request.scope());
    }
    if (!lit(request)) {
      return new Plan(request, plain, null, false, List.of());
    }
    List<LightInstance> reaching = request.steady() ? reach.of(request.scope()) : request.scope();
    float[] normals = mesh.normals();
    // Normal maps and the like need per-pixel lighting; fog depths cannot be refined.
    boolean detailed = shape.surface().detail() != null || mesh.fogDepth() >= 0;
    if (detailed || normals == null || mesh.primitive() != Mesh.Primitive.TRIANGLES) {
      return new Plan(request, plain, null, false, reaching);
    }
    SurfaceShading wished = shape.surface().shading();
    if (wished != SurfaceShading.UNSPECIFIED) {
      return new Plan(request, plain, null, wished == SurfaceShading.VERTEX, reaching);
    }
    if (!byVertex) {
      return new Plan(request, plain, null, false, reaching);
    }
    double scale = CurvatureTolerance.scale(shape.world());
    CurvatureTolerance wanted = CurvatureTolerance.of(shape.surface());
    if (CurvatureTolerance.mirrors(shape.surface(), survey, scale)) {
      return new Plan(request, plain, null, false, reaching);
    }
    boolean heavy = mesh.polygons() > HEAVY;
    boolean coarse = !heavy && wanted.finerThan(survey, scale);
    CurvatureTolerance needed = coarse ? wanted : CurvatureTolerance.NONE;
    RefinedMeshKey form = coarse ? new RefinedMeshKey(mesh, wanted.local(scale), null) : plain;
    double longest = survey.longest() * scale;
    double tolerance = tolerance(shape.surface(), mesh);
    if (!request.steady() || reach.departure(reaching, longest) <= tolerance) {
      return new Plan(request, form, null, true, reaching);
    }
    if (heavy) {
      return new Plan(request, plain, null, false, reaching);
    }
    MeshRefiner.Result result =
        MeshRefiner.refine(
            mesh, normals, shape.world(), needed, field(reaching), longest, tolerance);
    if (!result.complete()) {
      return new Plan(request, plain, null, false, reaching);
    }
    return result.forLight()
        ? new Plan(
            request,
            new RefinedMeshKey(mesh, needed, new Object()),
            result.staged(),
            true,
            reaching)
        : new Plan(request, form, null, true, reaching);
  }

  /** Returns whether the shaders light the shape. */
  private static boolean lit(Request request) {
    return request.shape().surface().lit() && request.mesh().normals() != null;
  }

  /** Returns the mesh of a key that is not bound to one place. */
  public static RefinedMesh mesh(RefinedMeshKey form) {
    float[] normals = form.source().normals();
    if (form.isPlain() || normals == null) {
      return RefinedMesh.of(form.source());
    }
    return MeshRefiner.refine(
            form.source(),
            normals,
            new Matrix4d(),
            form.fineness(),
            new DiffuseLightModel(List.of()),
            MeshMetrics.of(form.source()).longest(),
            TOLERANCE)
        .staged();
  }

  private static DiffuseLightModel field(List<LightInstance> lights) {
    return new DiffuseLightModel(
        lights.stream().filter(LightInstance::on).map(WorldSpaceLight::of).toList());
  }

  /** Returns the tolerance of a surface: a darker one shows less of an error. */
  private static double tolerance(SurfaceMaterial surface, Mesh mesh) {
    if (surface.shading() == SurfaceShading.VERTEX) {
      return Double.POSITIVE_INFINITY; // The author wants what is seen of it.
    }
    float[] d = surface.diffuse();
    boolean replaced = mesh.colors() != null || surface.texture() != null;
    double brightest = replaced ? 1 : Math.max(d[0], Math.max(d[1], d[2]));
    return TOLERANCE / Math.max(0.01, brightest);
  }
}
