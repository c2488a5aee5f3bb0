package org.selectiverenderer.validation.xml;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.x3d.source.DocumentError;

/** Reports the faults that the parser found. */
final class ParseFaultCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentError fault : file.document().faults()) {
      findings.add(rule(fault.kind()), fault.location(), "", fault.message());
    }
  }

  private static Rule rule(DocumentError.Kind kind) {
    return switch (kind) {
      case REFUSED -> XmlRules.NO_X3D;
      case COMPRESSION -> XmlRules.COMPRESSION;
      case ENCODING -> XmlRules.ENCODING;
      case ENTITY -> XmlRules.ENTITY;
      case SYNTAX -> XmlRules.NOT_WELL_FORMED;
      case MODEL -> XmlRules.MODEL;
      case LIMIT -> XmlRules.LIMIT;
    };
  }
}
