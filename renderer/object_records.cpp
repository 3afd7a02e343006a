#include "renderer/object_records.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {

ObjectRecords::ObjectRecords()
    : m_instances{"instances", GL_RGBA32UI}, m_flags{"instance flags", GL_R32UI}, m_materials{"materials", GL_RGBA32UI}
{
}

void ObjectRecords::instances(const gl::Buffer& records, const gl::Buffer& flags)
{
    m_instances.source(records.id(), 0, records.bytes());
    m_flags.source(flags.id(), 0, flags.bytes());
}

void ObjectRecords::instances(const GpuStream::Piece& records, const GpuStream::Piece& flags)
{
    m_instances.source(records.buffer, records.offset, records.bytes.size());
    m_flags.source(flags.buffer, flags.offset, flags.bytes.size());
}

void ObjectRecords::materials(const gl::Buffer& materials)
{
    m_materials.source(materials.id(), 0, materials.bytes());
}

void ObjectRecords::bind() const
{
    glBindTextureUnit(INSTANCES_UNIT, m_instances.id());
    glBindTextureUnit(INSTANCE_FLAGS_UNIT, m_flags.id());
    glBindTextureUnit(MATERIALS_UNIT, m_materials.id());
}

} // namespace renderer
