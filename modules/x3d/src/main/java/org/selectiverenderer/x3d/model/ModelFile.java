package org.selectiverenderer.x3d.model;

import java.util.Optional;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * A model to translate.
 *
 * @param name the name of the file in problems
 * @param bytes the content, decompressed, from 0 to {@code length}; must not be modified
 * @param files decides which other files the model may refer to; empty if none
 * @param base the base of the model's relative urls
 * @param limits the limits of the text that it becomes
 */
public record ModelFile(
    String name,
    ModelFormat format,
    byte[] bytes,
    int length,
    Optional<UrlResolver> files,
    BaseUrl base,
    ReadLimits limits) {}
